#include "host/mesh/msh/byte_source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace tentpole {

namespace {

constexpr const char* way_out = " The file is damaged, cut short or of another format: save it anew from Gmsh.";

bool is_blank(char character) {
  return character == ' ' || (character >= '\t' && character <= '\r');
}

/// A number beyond the range of double, which from_chars leaves alone: infinite or zero, as the standard library has
/// it.
double extreme_number(std::string_view word) {
  return std::strtod(std::string(word).c_str(), nullptr);
}

template <class Value>
bool parse(std::string_view word, Value& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return false;
  if constexpr (std::is_floating_point_v<Value>)
    if (error == std::errc::result_out_of_range) value = extreme_number(word);
  return error == std::errc{} || (std::is_floating_point_v<Value> && error == std::errc::result_out_of_range);
}

}  // namespace

std::string for_message(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  const auto is_unprintable = [](char character) { return character < ' ' || character > '~'; };
  std::replace_if(shown.begin(), shown.end(), is_unprintable, '?');
  return text.size() > longest ? shown + "..." : shown;
}

std::string quoted_for_message(std::string_view text) {
  return "\"" + for_message(text) + "\"";
}

void ByteSource::fail(const std::string& problem) const {
  const std::string_view before = bytes_.substr(0, item_);
  std::string place = encoding_.is_binary
                          ? "byte " + std::to_string(item_)
                          : "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
  if (!entity_.empty()) place += ", " + for_message(entity_);
  if (has_number_) place += " " + std::to_string(number_);
  throw MeshError(name_, place, problem);
}

void ByteSource::fail_at_end(const char* what) const {
  fail(std::string("the file ends where ") + what + " must be." + way_out);
}

bool ByteSource::has_more() {
  while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
  item_ = at_;
  return at_ < bytes_.size();
}

std::string_view ByteSource::word(const char* what) {
  if (!has_more()) fail_at_end(what);
  while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
  return bytes_.substr(item_, at_ - item_);
}

std::string_view ByteSource::rest_of_line() {
  item_ = at_;
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  at_ = std::min(end + 1, bytes_.size());
  std::string_view line = bytes_.substr(item_, end - item_);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  return line;
}

bool ByteSource::skip_behind(const std::string& text) {
  const std::size_t found = bytes_.find(text, at_);
  if (found == std::string_view::npos) return false;
  item_ = found;
  at_ = found + text.size();
  return true;
}

template <class Value>
Value ByteSource::text(const char* what, const char* kind) {
  const std::string_view found = word(what);
  Value value{};
  if (!parse(found, value))
    fail(quoted_for_message(found) + " stands where " + what + ", " + kind + ", must be." + way_out);
  return value;
}

template <class Value>
Value ByteSource::binary(const char* what) {
  item_ = at_;
  std::array<char, sizeof(Value)> bytes;
  if (bytes_.size() - at_ < bytes.size()) fail_at_end(what);
  std::memcpy(bytes.data(), bytes_.data() + at_, bytes.size());
  at_ += bytes.size();
  if (encoding_.swaps_bytes) std::reverse(bytes.begin(), bytes.end());
  Value value;
  std::memcpy(&value, bytes.data(), bytes.size());
  return value;
}

int ByteSource::integer(const char* what) {
  if (encoding_.is_binary) return binary<std::int32_t>(what);
  return text<std::int32_t>(what, "a whole number of 32 bits");
}

std::int64_t ByteSource::label(const char* what) {
  if (!encoding_.is_binary) return text_integer(what);
  return encoding_.label_bytes == 4 ? binary<std::int32_t>(what) : binary<std::int64_t>(what);
}

double ByteSource::number(const char* what) {
  return encoding_.is_binary ? binary<double>(what) : text_number(what);
}

std::int64_t ByteSource::text_integer(const char* what) {
  return text<std::int64_t>(what, "a whole number of 64 bits");
}

double ByteSource::text_number(const char* what) {
  return text<double>(what, "a number");
}

void ByteSource::skip_integers(std::size_t count, const char* what) {
  for (std::size_t i = 0; i < count; ++i) integer(what);
}

void ByteSource::skip_numbers(std::size_t count, const char* what) {
  for (std::size_t i = 0; i < count; ++i) number(what);
}

std::size_t ByteSource::checked_count(std::int64_t count, const char* what, std::size_t item_bytes) const {
  const std::size_t most = (bytes_.size() - at_ + 1) / item_bytes;
  if (count < 0 || static_cast<std::uint64_t>(count) > most)
    fail(std::string(what) + " is given as " + std::to_string(count) + ", but the rest of the file has room for " +
         std::to_string(most) + " at most." + way_out);
  return static_cast<std::size_t>(count);
}

std::size_t ByteSource::count(const char* what, MshItemSize item) {
  return checked_count(label(what), what, encoding_.is_binary ? item.bytes : 2 * item.words);
}

std::size_t ByteSource::text_count(const char* what, MshItemSize item) {
  return checked_count(text_integer(what), what, encoding_.is_binary ? item.bytes : 2 * item.words);
}

}  // namespace tentpole
