#include "tools/dial_options.h"

#include "tools/command.h"

namespace wander {

void DialOptions::require_for(const Method& method) const {
  for (const auto& [dial, text] : turned) require_dial(*dial, method);
}

void add_dial_options(Command verb, std::span<const std::string_view> words,
                      const std::shared_ptr<DialOptions>& options) {
  for (const std::string_view word : words) {
    const Dial& dial = find_dial(word);
    const auto turn = [options, &dial](const std::string& text) {
      dial.set(options->dials, text);
      options->turned.emplace_back(&dial, text);
    };
    if (dial.value.empty())
      verb.add_flag(
          dial.option(), [turn] { turn("on"); }, dial.help);
    else
      verb.add_option(dial.option(), turn, dial.help).type_name(std::string(dial.value));
  }
}

void add_dial_options(Command verb, const std::shared_ptr<DialOptions>& options) {
  std::vector<std::string_view> words;
  for (const Dial& dial : dials()) words.push_back(dial.word);
  add_dial_options(verb, words, options);
}

}  // namespace wander
