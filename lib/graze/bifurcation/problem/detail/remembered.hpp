// The answers to the questions asked last, where the same are asked again and again: of both ends
// of a step of a branch, and of a solution between.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace graze {

template <class Question, class Answer>
class Remembered {
 public:
  // The answer, by `find` where it is not remembered. The reference holds until another question is
  // asked.
  template <class Find>
  const Answer& answer(const Question& question, const Find& find) {
    for (const Known& known : known_)
      if (known.question == question) return known.answer;
    if (known_.size() == kMost) known_.pop_front();
    known_.push_back({question, find()});
    return known_.back().answer;
  }

 private:
  static constexpr std::size_t kMost = 3;

  struct Known {
    Question question;
    Answer answer;
  };
  std::deque<Known> known_;
};

}  // namespace graze
