#include "graze/structure/detail/line.hpp"

#include <algorithm>

namespace graze {

namespace {

Quartic constant(Rated number) { return {number}; }

// Numbers of a table and of its direction side by side.
template <class Table>
class Both {
 public:
  Both(const Table& here, const Table* rate) : here_(here), rate_(rate) {}

  Rated number(double Table::*which) const { return {here_.*which, rate_ ? rate_->*which : 0.0}; }
  Rated number(const std::optional<double> Table::*which) const {
    return {*(here_.*which), rate_ ? *(rate_->*which) : 0.0};
  }

 private:
  const Table& here_;
  const Table* rate_;
};

template <class List>
auto* entry(const List* list, std::size_t k) {
  return list ? &(*list)[k] : nullptr;
}

// One stretch of a section, from and to where it is given, seen on a piece.
struct SectionReach {
  Rated from, to;
};

// Length of a section along the piece from `start` to `end`, in the piece's own coordinate.
Quartic length_along(const Taper& taper, const Taper* rate, const SectionReach& reach, Rated start,
                     Rated end) {
  const Rated left{taper.front(), rate ? rate->front() : 0.0};
  if (taper.size() == 1) return constant(left);
  const Rated slope = (Rated{taper[1], rate ? (*rate)[1] : 0.0} - left) / (reach.to - reach.from);
  return {left + slope * (start - reach.from), slope * (end - start)};
}

SectionNumbers<Quartic> numbers_along(const Section& section, const Section* rate,
                                      const SectionReach& reach, Rated start, Rated end) {
  return section_numbers<Quartic>(section, [&](auto which) {
    return length_along(section.*which, rate ? &(rate->*which) : nullptr, reach, start, end);
  });
}

Rated number_of(const std::optional<double>& number, const std::optional<double>* rate) {
  return {*number, rate ? **rate : 0.0};
}

// Pieces of a beam (bending stiffness) or of a bar.
template <class Whole>
void add_pieces(Line& line, const Whole& whole, const Whole* rate, bool bends) {
  const SectionReach all{{0.0, 0.0}, line.length};
  const std::size_t count = std::max<std::size_t>(whole.pieces.size(), 1);
  const Both<Whole> numbers(whole, rate);
  Rated start{0.0, 0.0};
  for (std::size_t k = 0; k < count; ++k) {
    const Piece spare;
    const Piece& piece = whole.pieces.empty() ? spare : whole.pieces[k];
    const Piece* piece_rate =
        rate == nullptr ? nullptr : (whole.pieces.empty() ? &spare : &rate->pieces[k]);
    const auto own = [&](std::optional<double> Piece::*which) {
      return number_of(piece.*which, piece_rate ? &(piece_rate->*which) : nullptr);
    };
    const Rated end = piece.to ? own(&Piece::to) : line.length;
    const Rated modulus =
        piece.youngs_modulus ? own(&Piece::youngs_modulus) : numbers.number(&Whole::youngs_modulus);
    const Rated density = piece.density ? own(&Piece::density) : numbers.number(&Whole::density);
    SectionNumbers<Quartic> section{};
    if (piece.section) {
      section = numbers_along(*piece.section, piece_rate ? &*piece_rate->section : nullptr,
                              {start, end}, start, end);
    } else if (piece.area) {
      section.area = constant(own(&Piece::area));
      if (bends) section.second_moment = constant(own(&Piece::second_moment));
    } else if (whole.section) {
      section = numbers_along(*whole.section, rate ? &*rate->section : nullptr, all, start, end);
    } else {
      section.area = constant(number_of(whole.area, rate ? &rate->area : nullptr));
      if constexpr (requires { whole.second_moment; })
        section.second_moment =
            constant(number_of(whole.second_moment, rate ? &rate->second_moment : nullptr));
    }
    line.pieces.push_back({start, end, modulus * (bends ? section.second_moment : section.area),
                           density * section.area});
    start = end;
  }
}

void add_support(Line& line, Rated x, Hold hold) {
  const bool value = hold == Hold::kPinned || hold == Hold::kClamped;
  const bool slope = hold == Hold::kSliding || hold == Hold::kClamped;
  if (value || slope) line.supports.push_back({x, value, slope});
}

void add_places(Line& line, const Span& span, const Span* rate) {
  const auto place = [&](const std::optional<double>& position,
                         const std::optional<double>* moves) {
    return position ? number_of(position, moves) : line.length;
  };
  add_support(line, {0.0, 0.0}, span.ends[0]);
  add_support(line, line.length, span.ends[1]);
  for (std::size_t k = 0; k < span.supports.size(); ++k) {
    const Support& support = span.supports[k];
    const Support* moves = entry(rate ? &rate->supports : nullptr, k);
    const Both<Support> numbers(support, moves);
    const Rated x = place(support.position, moves ? &moves->position : nullptr);
    add_support(line, x, support.kind);
    if (support.kind != Hold::kSpring) continue;
    if (support.translational > 0.0)
      line.springs.push_back({x, numbers.number(&Support::translational), false});
    if (support.rotational > 0.0)
      line.springs.push_back({x, numbers.number(&Support::rotational), true});
  }
  for (std::size_t k = 0; k < span.masses.size(); ++k) {
    const AttachedMass& mass = span.masses[k];
    const AttachedMass* moves = entry(rate ? &rate->masses : nullptr, k);
    const Both<AttachedMass> numbers(mass, moves);
    line.masses.push_back({place(mass.position, moves ? &moves->position : nullptr),
                           numbers.number(&AttachedMass::mass),
                           numbers.number(&AttachedMass::inertia)});
  }
}

}  // namespace

Line line_of(const Scene& scene, const Scene* direction) {
  const Span& span = *scene.span();
  const Span* rate = direction ? direction->span() : nullptr;
  Line line;
  line.length = Both<Span>(span, rate).number(&Span::length);
  if (const Beam* beam = scene.beam()) {
    const Beam* beam_rate = direction ? direction->beam() : nullptr;
    add_pieces(line, *beam, beam_rate, true);
    if (beam->tension)
      line.tension = number_of(beam->tension, beam_rate ? &beam_rate->tension : nullptr);
  } else if (const Bar* bar = scene.bar()) {
    line.order = 1;
    add_pieces(line, *bar, direction ? direction->bar() : nullptr, false);
  } else {
    line.order = 1;
    const TautString* string_rate = direction ? direction->string() : nullptr;
    const Both<TautString> string(*scene.string(), string_rate);
    // Where frequencies are given they stand for the tension, which nothing else depends on.
    const std::optional<double>& tension = scene.string()->tension;
    line.pieces.push_back(
        {{0.0, 0.0},
         line.length,
         constant(tension ? number_of(tension, string_rate ? &string_rate->tension : nullptr)
                          : Rated{}),
         constant(string.number(&TautString::mass_per_length))});
  }
  add_places(line, span, rate);
  return line;
}

SectionNumbers<Rated> even_section(const Beam& beam, const Beam* rate) {
  if (!beam.section)
    return {number_of(beam.area, rate ? &rate->area : nullptr),
            number_of(beam.second_moment, rate ? &rate->second_moment : nullptr)};
  return section_numbers<Rated>(*beam.section, [&](auto which) {
    return Rated{(*beam.section.*which).front(), rate ? (*rate->section.*which).front() : 0.0};
  });
}

double thickness_at(const Beam& beam, double x) {
  const Section* section = beam.section ? &*beam.section : nullptr;
  double from = 0.0, to = beam.length, start = 0.0;
  for (const Piece& piece : beam.pieces) {
    const double end = piece.to.value_or(beam.length);
    if (x <= end || !piece.to) {
      if (piece.section) {
        section = &*piece.section;
        from = start;
        to = end;
      } else if (piece.area) {
        section = nullptr;
      }
      break;
    }
    start = end;
  }
  if (section == nullptr) return *beam.thickness;
  const Taper& height =
      section->shape == SectionShape::kRectangle ? section->height : section->diameter;
  return height.front() + (height.back() - height.front()) * (x - from) / (to - from);
}

}  // namespace graze
