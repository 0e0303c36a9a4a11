#include "graze/report/picture/picture_request.hpp"

namespace graze {

const char* name_of(LabelChoice choice) {
  switch (choice) {
    case LabelChoice::kNone:
      return "none";
    case LabelChoice::kSpecial:
      return "special";
    case LabelChoice::kAll:
      break;
  }
  return "all";
}

const char* name_of(PictureStyle style) {
  return style == PictureStyle::kSlide ? "slide" : "paper";
}

}  // namespace graze
