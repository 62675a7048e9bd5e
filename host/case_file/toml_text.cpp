#include "host/case_file/toml_text.hpp"

#include "common/utf8.hpp"

namespace tentpole {
namespace {

/// Goes through the text by characters and knows what part of the file it is in.
class TomlTextScanner {
 public:
  explicit TomlTextScanner(std::string_view text) : rest_(text) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  }

  std::optional<TomlTextFault> scan() {
    while (!rest_.empty() && !fault_) step();
    return fault_;
  }

 private:
  enum class Part { plain, comment, basic, literal, long_basic, long_literal };

  void report(const std::string& reason) { fault_ = {line_, column_, reason}; }

  bool is_at(std::string_view start) const { return rest_.starts_with(start); }

  void pass_character(std::size_t size) {
    rest_.remove_prefix(size);
    ++column_;
  }

  void pass_ascii(int num_characters) {
    for (int i = 0; i < num_characters; ++i) pass_character(1);
  }

  void step() {
    const std::size_t size = utf8_character_size(rest_);
    if (size == 0) return report("this byte is no UTF-8, which TOML is written in. Save the file as UTF-8.");
    if (is_at("\n")) return end_line();
    switch (part_) {
      case Part::plain:
        return step_plain(size);
      case Part::comment:
        return pass_character(size);
      case Part::basic:
        return step_with_escapes(size, "\"");
      case Part::long_basic:
        return step_with_escapes(size, "\"\"\"");
      case Part::literal:
        return step_quoted(size, "'");
      case Part::long_literal:
        return step_quoted(size, "'''");
    }
  }

  /// A backslash that keeps a quotation mark or backslash behind it from ending the text.
  bool is_escape() const { return is_at("\\\"") || is_at("\\\\"); }

  /// The parser skips blanks and ends of lines behind a backslash, and takes for granted that the next letter is ASCII.
  void step_with_escapes(std::size_t size, std::string_view end) {
    if (skips_blanks_ && size > 1)
      return report(
          "a letter beyond ASCII follows a backslash or the blanks behind one. Double the backslash, or write the "
          "text without it.");
    const bool is_blank = is_at(" ") || is_at("\t") || is_at("\r");
    skips_blanks_ = (skips_blanks_ && is_blank) || (is_at("\\") && !is_escape());
    return is_escape() ? pass_ascii(2) : step_quoted(size, end);
  }

  void end_line() {
    rest_.remove_prefix(1);
    ++line_;
    column_ = 1;
    num_parts_ = 1;
    is_line_empty_ = true;
    if (is_header_) depth_ = 0;
    is_header_ = false;
    if (part_ != Part::long_basic) skips_blanks_ = false;
    if (part_ != Part::long_basic && part_ != Part::long_literal) part_ = Part::plain;
  }

  /// Up to two quotation marks may stand before the three that end a long text.
  void step_quoted(std::size_t size, std::string_view end) {
    if (!is_at(end)) return pass_character(size);
    pass_ascii(static_cast<int>(end.size()));
    for (int more = 0; end.size() == 3 && more < 2 && is_at(end.substr(0, 1)); ++more) pass_ascii(1);
    part_ = Part::plain;
  }

  void open_quotes(Part usual, Part longer, std::string_view three) {
    const bool is_long = is_at(three);
    part_ = is_long ? longer : usual;
    pass_ascii(is_long ? 3 : 1);
  }

  void step_plain(std::size_t size) {
    const char character = rest_[0];
    if (size > 1) return report("a letter beyond ASCII needs quotation marks here. Put the name or text into \"...\".");
    if ((character < ' ' && character != '\t' && character != '\r') || character == 0x7f)
      return report("a control character stands here. Remove it.");
    if (character == '"') return open_quotes(Part::basic, Part::long_basic, "\"\"\"");
    if (character == '\'') return open_quotes(Part::literal, Part::long_literal, "'''");
    if (character == '#') part_ = Part::comment;
    follow_structure(character);
    if (character != ' ' && character != '\t') is_line_empty_ = false;
    pass_ascii(1);
  }

  void follow_structure(char character) {
    const std::string most = std::to_string(deepest_toml_nesting);
    if (character == '[' || character == '{') {
      if (character == '[' && is_line_empty_ && depth_ == 0) is_header_ = true;
      if (++depth_ > deepest_toml_nesting)
        report("brackets are nested more than " + most + " deep. Close those that stand open, or write fewer of them.");
    }
    if ((character == ']' || character == '}') && depth_ > 0) --depth_;
    if (character == '.' && ++num_parts_ > deepest_toml_nesting)
      report("a key of more than " + most + " parts. Remove parts; no key of a case has that many.");
    if (std::string_view("=,[]{}").find(character) != std::string_view::npos) num_parts_ = 1;
  }

  std::string_view rest_;
  Part part_ = Part::plain;
  int line_ = 1, column_ = 1;
  int depth_ = 0;
  int num_parts_ = 1;          ///< of the dotted key at hand
  bool is_line_empty_ = true;  ///< up to here
  bool skips_blanks_ = false;  ///< between a backslash in a text and the next letter
  bool is_header_ = false;     ///< the line began with a bracket: what it leaves open ends with it
  std::optional<TomlTextFault> fault_;
};

}  // namespace

std::optional<TomlTextFault> find_toml_text_fault(std::string_view text) {
  return TomlTextScanner(text).scan();
}

}  // namespace tentpole
