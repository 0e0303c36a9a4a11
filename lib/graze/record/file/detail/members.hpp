// The members of a value, one after the other, for code that does the same with each: writes or
// reads it. They are all members of the type in order, so that none can be forgotten when one is
// added.
//
// A type without constructors, bases and C arrays has as many members as its braces accept
// initialisers; so many names can be bound to them.
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

namespace graze {

// Converts to any type in unevaluated expressions.
struct AnyValue {
  explicit AnyValue(std::size_t);
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor)
};

template <class T, std::size_t... I>
constexpr bool takes_values(std::index_sequence<I...>) {
  return requires { T{AnyValue(I)...}; };
}

inline constexpr std::size_t kMostMembers = 26;

template <class T, std::size_t most = kMostMembers + 1>
constexpr std::size_t member_count() {
  static_assert(most > 0, "no value with members");
  if constexpr (takes_values<T>(std::make_index_sequence<most>()))
    return most;
  else
    return member_count<T, most - 1>();
}

// References to `count` members.
template <std::size_t count>
struct Members {};
template <class T>
auto tied(T& value, Members<1>) {
  auto& [a] = value;
  return std::tie(a);
}
template <class T>
auto tied(T& value, Members<2>) {
  auto& [a, b] = value;
  return std::tie(a, b);
}
template <class T>
auto tied(T& value, Members<3>) {
  auto& [a, b, c] = value;
  return std::tie(a, b, c);
}
template <class T>
auto tied(T& value, Members<4>) {
  auto& [a, b, c, d] = value;
  return std::tie(a, b, c, d);
}
template <class T>
auto tied(T& value, Members<5>) {
  auto& [a, b, c, d, e] = value;
  return std::tie(a, b, c, d, e);
}
template <class T>
auto tied(T& value, Members<6>) {
  auto& [a, b, c, d, e, f] = value;
  return std::tie(a, b, c, d, e, f);
}
template <class T>
auto tied(T& value, Members<7>) {
  auto& [a, b, c, d, e, f, g] = value;
  return std::tie(a, b, c, d, e, f, g);
}
template <class T>
auto tied(T& value, Members<8>) {
  auto& [a, b, c, d, e, f, g, h] = value;
  return std::tie(a, b, c, d, e, f, g, h);
}
template <class T>
auto tied(T& value, Members<9>) {
  auto& [a, b, c, d, e, f, g, h, i] = value;
  return std::tie(a, b, c, d, e, f, g, h, i);
}
template <class T>
auto tied(T& value, Members<10>) {
  auto& [a, b, c, d, e, f, g, h, i, j] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j);
}
template <class T>
auto tied(T& value, Members<11>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
template <class T>
auto tied(T& value, Members<12>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
}
template <class T>
auto tied(T& value, Members<13>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
}
template <class T>
auto tied(T& value, Members<14>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
}
template <class T>
auto tied(T& value, Members<15>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
}
template <class T>
auto tied(T& value, Members<16>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
}
template <class T>
auto tied(T& value, Members<17>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
}
template <class T>
auto tied(T& value, Members<18>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r);
}
template <class T>
auto tied(T& value, Members<19>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
}
template <class T>
auto tied(T& value, Members<20>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t);
}
template <class T>
auto tied(T& value, Members<21>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);
}
template <class T>
auto tied(T& value, Members<22>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v);
}
template <class T>
auto tied(T& value, Members<23>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w);
}
template <class T>
auto tied(T& value, Members<24>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x);
}
template <class T>
auto tied(T& value, Members<25>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y);
}
template <class T>
auto tied(T& value, Members<26>) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z] = value;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z);
}

// `use` is called with all members of `value`.
template <class T, class Use>
void with_members(T& value, const Use& use) {
  constexpr std::size_t count = member_count<T>();
  static_assert(count <= kMostMembers, "tie more members above");
  std::apply(use, tied(value, Members<count>()));
}

}  // namespace graze
