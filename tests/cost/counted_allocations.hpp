// How often this program asked for memory: every malloc and operator new, of any thread.
#pragma once

namespace graze::cost {

long long allocations();

}  // namespace graze::cost
