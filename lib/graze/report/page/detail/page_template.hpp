// The page of --plot x.html without its data, as lib/graze/report/page makes it at build time.
#pragma once

#include <string_view>

namespace graze {

// An HTML text with the mark <!--data--> where the data belong; empty in a program that was built
// without npm.
std::string_view page_template();

}  // namespace graze
