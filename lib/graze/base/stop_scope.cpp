#include "graze/base/detail/stop_scope.hpp"

namespace graze {
namespace {

thread_local StopSignal of_this_thread;

}  // namespace

StopScope::StopScope(const StopSignal& stop) : before_(of_this_thread) { of_this_thread = stop; }

StopScope::~StopScope() { of_this_thread = before_; }

const StopSignal& StopScope::current() { return of_this_thread; }

}  // namespace graze
