#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host/mesh/mesh_error.hpp"

namespace tentpole {

/// How the numbers of a .msh file are written.
struct MshEncoding {
  bool is_binary = false;
  bool swaps_bytes = false;  ///< binary, from a machine of the other byte order
  int label_bytes = 8;       ///< binary: 4 or 8 for labels of nodes and elements, and for counts
};

/// The least that one item of a list takes in the file; bounds what may be allocated for a list.
struct MshItemSize {
  std::size_t words;  ///< text: separated by blanks
  std::size_t bytes;  ///< binary
};

/// The bytes of a .msh file and a place in them. Nothing reads beyond the end, and whatever is not there or not what it
/// must be throws a MeshError with the line (of text) or the byte (of binary data), the entity that was entered last,
/// and `what` was expected.
class ByteSource {
 public:
  /// Keeps a view of `bytes`. `name` opens every message.
  ByteSource(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {}

  const MshEncoding& encoding() const { return encoding_; }
  void set_encoding(const MshEncoding& encoding) { encoding_ = encoding; }

  /// Names what is read from here on for messages: "element 7", or "$Elements" where there is no number yet.
  void enter(std::string_view entity) {
    entity_ = entity;
    has_number_ = false;
  }
  void enter(std::string_view entity, std::int64_t number) {
    entity_ = entity;
    number_ = number;
    has_number_ = true;
  }

  // --- numbers, as the encoding says; as text separated by blanks and ends of lines
  int integer(const char* what);
  std::int64_t label(const char* what);
  double number(const char* what);
  void skip_integers(std::size_t count, const char* what);
  void skip_numbers(std::size_t count, const char* what);
  /// The length of a list, as a label. Refused if the rest of the file cannot hold so many items.
  std::size_t count(const char* what, MshItemSize item);

  // --- text, whatever the encoding
  std::int64_t text_integer(const char* what);
  double text_number(const char* what);
  std::size_t text_count(const char* what, MshItemSize item);
  /// Passes blanks and ends of lines; whether something follows.
  bool has_more();
  /// The next character, '\0' at the end; blanks are passed.
  char next_character() { return has_more() ? bytes_[at_] : '\0'; }
  /// The next word, which begins no later than at the end of the file.
  std::string_view word(const char* what);
  /// What is left of the line; the place is then the start of the next.
  std::string_view rest_of_line();
  /// Moves behind the next occurrence of a text; false, and nowhere, if there is none.
  bool skip_behind(const std::string& text);

  /// Throws a MeshError at the last item that was read.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  template <class Value>
  Value binary(const char* what);
  template <class Value>
  Value text(const char* what, const char* kind);
  std::size_t checked_count(std::int64_t count, const char* what, std::size_t item_bytes) const;
  [[noreturn]] void fail_at_end(const char* what) const;

  std::string name_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t item_ = 0;  ///< where the last item began
  MshEncoding encoding_;
  std::string_view entity_;
  std::int64_t number_ = 0;
  bool has_number_ = false;
};

/// A piece of a file for a message: at most 40 characters, printable ones only; in quotes.
std::string for_message(std::string_view text);
std::string quoted_for_message(std::string_view text);

}  // namespace tentpole
