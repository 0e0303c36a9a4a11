#include "graze/study/ranks/first_rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/base/stop_scope.hpp"
#include "graze/study/ranks/listener.hpp"

namespace graze {

using Kind = RankMessage::Kind;

bool PieceTable::has(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return texts_.count(name) > 0;
}

std::optional<std::string> PieceTable::find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = texts_.find(name);
  if (found == texts_.end()) return {};
  return found->second;
}

void PieceTable::add(const std::string& name, const std::string& text) {
  const std::lock_guard lock(mutex_);
  texts_.emplace(name, text);
}

void PieceTable::clear() {
  const std::lock_guard lock(mutex_);
  texts_.clear();
}

FirstRank::FirstRank(RankMessages& messages, std::atomic<bool>& interrupted)
    : messages_(messages),
      interrupted_(interrupted),
      others_(static_cast<std::size_t>(messages.ranks())) {}

PieceStore* FirstRank::begin(const std::string& work, const std::string& processor,
                             PieceStore* kept) {
  work_ = work;
  processors_.insert(processor);
  store_ = kept ? kept : &table_;
  return messages_.ranks() > 1 ? store_ : kept;
}

bool FirstRank::do_blocks(const BlockWork& work, int threads, const StopSignal& stop) {
  if (messages_.ranks() == 1) return own_threads().do_blocks(work, threads, stop);
  threads_ = thread_count(threads);
  start_phase(work, stop);
  const StopScope::Handle scope = StopScope::handle();
  {
    const Listener listener(
        messages_,
        [&](int from, const RankMessage& message) {
          const StopScope same(scope);
          take(from, message);
        },
        [&] { return look(); });
    try {
      for_each_index(static_cast<std::size_t>(threads_), threads,
                     [&](std::size_t) { work_here(); });
    } catch (...) {
      fail(std::current_exception());  // the listener must not wait for ever
    }
    const std::lock_guard lock(mutex_);
    has_finished_here_ = true;
  }
  tell_all({Kind::kPhaseOver, {phase_}});
  if (failure_) std::rethrow_exception(failure_);
  return true;
}

// Blocks whose pieces only have to be recalled are not worth a message.
void FirstRank::start_phase(const BlockWork& work, const StopSignal& stop) {
  const std::lock_guard lock(mutex_);
  ++phase_;
  blocks_ = &work;
  stop_ = stop;
  own_.clear(), open_.clear();
  has_told_stop_ = has_finished_here_ = false;
  for (const std::size_t block : work.blocks) {
    const std::vector<std::string> pieces = work.pieces(block);
    const bool is_known = std::all_of(pieces.begin(), pieces.end(),
                                      [&](const std::string& name) { return store_->has(name); });
    (is_known ? own_ : open_).push_back(block);
  }
}

void FirstRank::work_here() {
  try {
    const std::size_t workers = others_.size() * static_cast<std::size_t>(threads_);
    blocks_->run({[this](bool waits) { return next_block(waits); }, [](std::size_t, bool) {},
                  even_part(blocks_->blocks.size(), workers)});
  } catch (...) {
    fail(std::current_exception());
  }
}

// Waits while there is none left but others may return one unfinished; nullopt when the phase is
// over.
std::optional<std::size_t> FirstRank::next_block(bool waits) {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (is_ending()) return {};
    for (std::deque<std::size_t>* list : {&own_, &open_}) {
      if (list->empty()) continue;
      const std::size_t block = list->front();
      list->pop_front();
      return block;
    }
    if (given_ == 0 || !waits) return {};
    // A stop that is not announced is noticed within this time.
    changed_.wait_for(lock, std::chrono::milliseconds(50));
  }
}

void FirstRank::take(int from, const RankMessage& message) noexcept {
  try {
    answer(from, message);
  } catch (...) {
    fail(std::current_exception());
  }
}

void FirstRank::answer(int from, const RankMessage& message) {
  Other& other = others_[static_cast<std::size_t>(from)];
  switch (message.kind) {
    case Kind::kJoin:
      return note_joined(from, message);
    case Kind::kWant:
      other.wanted_phase = message.numbers.at(0), other.wish = message.numbers.at(1);
      return hand_out(from, other);
    case Kind::kPiece:
      for (const auto& [name, text] : message.texts)
        if (!store_->has(name)) store_->add(name, text);
      return;
    case Kind::kDone:
      return note_done(other, message.numbers.at(0), message.numbers.at(1) == 1);
    case Kind::kInterrupted:
      interrupted_ = true;
      return;
    case Kind::kFailed: {
      const std::string sentence = fmt::format("rank {}: {}", from, message.names.at(0));
      if (message.numbers.at(0) == 2) throw InputError(sentence);
      throw FileError(sentence);
    }
    case Kind::kGone: {
      const std::lock_guard lock(mutex_);
      given_ -= other.blocks.size();
      own_.insert(own_.end(), other.blocks.begin(), other.blocks.end());
      other.blocks.clear();
      other.is_gone = true;
      return;
    }
    default:
      return;
  }
}

void FirstRank::note_joined(int from, const RankMessage& message) {
  if (message.names.at(0) != work_)
    throw InputError(fmt::format(
        "rank {}: its work is another one; all ranks need the same program and the same "
        "scene",
        from));
  processors_.insert(message.names.at(1));
}

// Blocks that another rank finished are recalled here by the same steps by which they are done.
void FirstRank::note_done(Other& other, std::uint64_t block, bool is_finished) {
  {
    const std::lock_guard lock(mutex_);
    if (other.blocks.erase(block) > 0) --given_;
    if (!is_finished) own_.push_back(block);
    changed_.notify_all();
    if (!is_finished || is_ending()) return;
  }
  std::optional<std::size_t> left = block;
  blocks_->run(
      {[&](bool) { return std::exchange(left, std::nullopt); }, [](std::size_t, bool) {}, 1});
}

void FirstRank::hand_out(int to, Other& other) {
  RankMessage message{Kind::kBlocks};
  {
    const std::lock_guard lock(mutex_);
    if (other.wanted_phase != phase_ || !blocks_ || is_ending()) return;
    for (const std::size_t block : batch(other)) {
      message.numbers.push_back(block);
      other.blocks.insert(block);
    }
    given_ += message.numbers.size();
  }
  if (message.numbers.empty()) return;  // it waits until the phase is over
  other.wanted_phase = 0;
  for (const std::uint64_t block : message.numbers)
    for (const std::string& name : blocks_->pieces(block))
      if (const std::optional<std::string> text = store_->find(name))
        message.texts.emplace_back(name, *text);
  messages_.send(to, bytes_of(message));
}

// Fewer at a time towards the end, so that all ranks end together.
std::vector<std::size_t> FirstRank::batch(const Other& other) {
  const std::size_t fair = open_.size() / (2 * others_.size());
  const auto count = std::min(
      std::clamp<std::size_t>(other.wish, 1, std::max<std::size_t>(fair, 1)), open_.size());
  const auto end = open_.begin() + static_cast<std::ptrdiff_t>(count);
  std::vector<std::size_t> blocks(open_.begin(), end);
  open_.erase(open_.begin(), end);
  return blocks;
}

// Between messages: answers requests from before this phase began, and ends the ranks.
bool FirstRank::look() noexcept {
  try {
    bool is_stopped_now = false;
    {
      const std::lock_guard lock(mutex_);
      if (has_finished_here_ && given_ == 0) return false;
      is_stopped_now = is_ending() && !has_told_stop_;
      has_told_stop_ = has_told_stop_ || is_stopped_now;
    }
    if (is_stopped_now) tell_all({Kind::kStop});
    for (std::size_t rank = 1; rank < others_.size(); ++rank)
      if (others_[rank].wanted_phase == phase_) hand_out(static_cast<int>(rank), others_[rank]);
  } catch (...) {
    fail(std::current_exception());
  }
  return true;
}

void FirstRank::tell_all(const RankMessage& message) {
  for (int rank = 1; rank < messages_.ranks(); ++rank) messages_.send(rank, bytes_of(message));
}

void FirstRank::fail(std::exception_ptr failure) {
  const std::lock_guard lock(mutex_);
  if (!failure_) failure_ = std::move(failure);
  changed_.notify_all();
}

void FirstRank::close() {
  tell_all({Kind::kOver});
  const auto is_gone = [](const Other& other) { return other.is_gone; };
  blocks_ = nullptr;
  const Listener listener(
      messages_,
      [&](int from, const RankMessage& message) {
        if (message.kind == Kind::kGone) others_[static_cast<std::size_t>(from)].is_gone = true;
      },
      [&] {
        return !messages_.has_left() || !std::all_of(others_.begin() + 1, others_.end(), is_gone);
      });
}

}  // namespace graze
