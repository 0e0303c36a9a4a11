#include "graze/record/run_picture.hpp"

namespace graze {

const char* name_of(RunPicture picture) {
  switch (picture) {
    case RunPicture::kMotion:
      return "motion";
    case RunPicture::kReturns:
      return "returns";
    case RunPicture::kSpectrum:
      return "spectrum";
    case RunPicture::kPsd:
      return "psd";
    case RunPicture::kShapes:
      return "shapes";
    case RunPicture::kForces:
      break;
  }
  return "forces";
}

}  // namespace graze
