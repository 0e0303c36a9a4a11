// The words that stand for choices in a scene.
#pragma once

#include <array>

#include "graze/scene/scene.hpp"

namespace graze {

// A word of the scene and what it stands for; the first of several is taken where none is given.
template <class Value>
struct Choice {
  const char* name;
  Value value;
};
template <class Value>
Choice(const char*, Value) -> Choice<Value>;

template <class Choices, class Value>
const char* name_among(const Choices& choices, Value value) {
  for (const auto& choice : choices)
    if (choice.value == value) return choice.name;
  return "";
}

inline constexpr std::array kUnitWords{Choice{"SI", Units::kSi}, Choice{"none", Units::kNone}};

enum class TorqueKind { kPulse, kTable };

inline constexpr std::array kProjections{Choice{"galerkin", Projection::kGalerkin},
                                         Choice{"collocation", Projection::kCollocation}};
inline constexpr std::array kSectionShapes{Choice{"rectangle", SectionShape::kRectangle},
                                           Choice{"circle", SectionShape::kCircle},
                                           Choice{"tube", SectionShape::kTube}};
inline constexpr std::array kBeamEnds{
    Choice{"clamped", Hold::kClamped}, Choice{"pinned", Hold::kPinned},
    Choice{"sliding", Hold::kSliding}, Choice{"free", Hold::kFree}};
inline constexpr std::array kLineEnds{Choice{"fixed", Hold::kPinned}, Choice{"free", Hold::kFree}};
inline constexpr std::array kBeamSupports{
    Choice{"spring", Hold::kSpring}, Choice{"pinned", Hold::kPinned},
    Choice{"clamped", Hold::kClamped}, Choice{"sliding", Hold::kSliding}};
inline constexpr std::array kLineSupports{Choice{"spring", Hold::kSpring},
                                          Choice{"fixed", Hold::kPinned}};
inline constexpr std::array kTorqueKinds{Choice{"pulse", TorqueKind::kPulse},
                                         Choice{"table", TorqueKind::kTable}};
inline constexpr std::array kHubEquations{Choice{"consistent", HubEquations::kConsistent},
                                          Choice{"paper", HubEquations::kPaper}};
inline constexpr std::array kBeamForcings{Choice{"base", ForcingKind::kBase},
                                          Choice{"distributed", ForcingKind::kDistributed},
                                          Choice{"point", ForcingKind::kPoint},
                                          Choice{"none", ForcingKind::kNone}};
inline constexpr std::array kModalForcings{Choice{"modal", ForcingKind::kModal},
                                           Choice{"base", ForcingKind::kBase},
                                           Choice{"point", ForcingKind::kPoint},
                                           Choice{"none", ForcingKind::kNone}};
inline constexpr std::array kMatrixForcings{Choice{"base", ForcingKind::kBase},
                                            Choice{"load", ForcingKind::kModal},
                                            Choice{"point", ForcingKind::kPoint},
                                            Choice{"support", ForcingKind::kSupport},
                                            Choice{"none", ForcingKind::kNone}};
inline constexpr std::array kLumpedForcings{Choice{"base", ForcingKind::kBase},
                                            Choice{"point", ForcingKind::kPoint},
                                            Choice{"support", ForcingKind::kSupport},
                                            Choice{"none", ForcingKind::kNone}};
inline constexpr std::array kSpectrumSides{Choice{"one", SpectrumSides::kOne},
                                           Choice{"two", SpectrumSides::kTwo}};
inline constexpr std::array kBaseRecords{Choice{"acceleration", BaseRecord::kAcceleration},
                                         Choice{"displacement", BaseRecord::kDisplacement}};
inline constexpr std::array kFrames{Choice{"clamp", StopFrame::kClamp},
                                    Choice{"space", StopFrame::kSpace}};
inline constexpr std::array kStarts{Choice{"given", false}, Choice{"equilibrium", true}};
inline constexpr std::array kSides{Choice{"above", Side::kAbove}, Choice{"below", Side::kBelow}};
inline constexpr std::array kImpulses{Choice{"momentum", Impulse::kMomentum},
                                      Choice{"collocation", Impulse::kCollocation}};
inline constexpr std::array kReleases{Choice{"force", Separation::kAtZeroForce},
                                      Choice{"position", Separation::kAtZeroDepth}};
inline constexpr std::array kInversions{Choice{"published", false}, Choice{"exact", true}};
inline constexpr std::array kContactModels{
    Choice{"kelvin-voigt", ContactModel::kKelvinVoigt},
    Choice{"lee-wang-1", ContactModel::kLeeWang1},
    Choice{"lee-wang-2", ContactModel::kLeeWang2},
    Choice{"hunt-crossley", ContactModel::kHuntCrossley},
    Choice{"lankarani-nikravesh", ContactModel::kLankaraniNikravesh},
    Choice{"flores", ContactModel::kFlores},
    Choice{"adams", ContactModel::kAdams},
    Choice{"jankowski", ContactModel::kJankowski},
    Choice{"elasto-gap", ContactModel::kElastoGap}};
inline constexpr std::array kQuantities{Choice{"displacement", ProbeQuantity::kDisplacement},
                                        Choice{"velocity", ProbeQuantity::kVelocity},
                                        Choice{"deflection", ProbeQuantity::kDeflection},
                                        Choice{"strain", ProbeQuantity::kStrain},
                                        Choice{"angle", ProbeQuantity::kAngle},
                                        Choice{"rate", ProbeQuantity::kRate}};
inline constexpr std::array kFlows{Choice{"auto", FlowChoice::kAuto},
                                   Choice{"exact", FlowChoice::kExact},
                                   Choice{"rk4", FlowChoice::kRk4},
                                   Choice{"dopri5", FlowChoice::kDopri5},
                                   Choice{"fehlberg78", FlowChoice::kFehlberg78},
                                   Choice{"bulirsch-stoer", FlowChoice::kBulirschStoer}};

}  // namespace graze
