// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "completion.hpp"

#include "failure.hpp"
#include "session.hpp"

#include <algorithm>
#include <exception>

namespace oroforge::live_client {
namespace {

constexpr std::chrono::milliseconds kPatience{300};  // of a person who has pressed TAB

bool beginsWith(const std::string& text, const std::string& with) { return text.compare(0, with.size(), with) == 0; }

/** The words behind `oro`, as far as they are understood. */
struct Typed {
    const Command* command = nullptr;
    std::size_t arguments = 0;        ///< before the last word
    const Option* waiting = nullptr;  ///< the last word is its value
    Given given;                      ///< options that choose the deployment
};

const Option* optionNamed(const Command* command, const std::string& word) {
    const auto has = [&](const Option& option) {
        const std::string names = "," + std::string(option.names) + ",";
        return names.find("," + word + ",") != std::string::npos;
    };
    for (const Option& option : commonOptions())
        if (has(option)) return &option;
    if (command)
        for (const Option& option : command->options)
            if (has(option)) return &option;
    return nullptr;
}

Typed understand(const std::vector<std::string>& words) {
    Typed typed;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::string& word = words[i];
        if (typed.waiting) {
            typed.given.options[keyOf(*typed.waiting)] = word;
            typed.waiting = nullptr;
        } else if (word.size() > 1 && word[0] == '-') {
            const std::size_t equals = word.find('=');
            const Option* const option = optionNamed(typed.command, word.substr(0, equals));
            if (option && option->value && equals == std::string::npos)
                typed.waiting = option;
            else if (option)
                typed.given.options[keyOf(*option)] = equals == std::string::npos ? "true" : word.substr(equals + 1);
        } else if (!typed.command) {
            typed.command = commandNamed(word);
        } else {
            ++typed.arguments;
        }
    }
    return typed;
}

/** Names of a running deployment. */
class Running {
public:
    explicit Running(Given given) : given_(std::move(given)), out_(-1), session_(withPatience(given_), out_) {}

    std::vector<Candidate> names(Names kind, const std::string& word) {
        const std::size_t dot = word.rfind('.');
        const bool within = kind != Names::Component;
        if (dot != std::string::npos && within) return parts(kind, word.substr(0, dot));
        std::vector<Candidate> found;
        const Json tree = session_.deployment().ask("tree");
        for (const Json& component : memberOf(tree, "components")) {
            const std::string name = printable(textOf(component, "name"));
            found.push_back({name + (within ? "." : ""), printable(textOf(component, "state"))});
            if (kind == Names::Part) found.push_back({name, printable(textOf(component, "type"))});
        }
        return found;
    }

private:
    static const Given& withPatience(Given& given) {
        given.options["timeout"] = std::to_string(static_cast<double>(kPatience.count()) / 1000);
        return given;
    }

    std::vector<Candidate> parts(Names kind, const std::string& whole) {
        const Json found = session_.deployment().ask("show", {{"path", whole}});
        std::vector<Candidate> all;
        const auto add = [&](const char* list, const char* behind, const char* direction = nullptr) {
            for (const Json& part : memberOf(found, list)) {
                if (direction && textOf(part, "direction") != direction) continue;
                const std::string name = part.is_string() ? part.get<std::string>() : textOf(part, "name");
                all.push_back({printable(whole + "." + name + behind), printable(textOf(part, "doc"))});
            }
        };
        if (kind == Names::Value || kind == Names::Part) {
            add("properties", "");
            add("attributes", "");
        }
        if (kind == Names::Operation || kind == Names::Part) add("operations", "");
        if (kind == Names::Port) add("ports", "", "out");
        if (kind == Names::Part) add("ports", "");
        add("services", ".");
        return all;
    }

    Given given_;
    Output out_;
    Session session_;
};

std::vector<Candidate> wordsOf(const std::vector<const char*>& words) {
    std::vector<Candidate> all;
    for (const char* const word : words) all.push_back({word, ""});
    return all;
}

std::vector<Candidate> namesOf(Names kind, const std::string& word, const Given& given) {
    switch (kind) {
        case Names::Shell: return wordsOf({"bash", "zsh", "fish"});
        case Names::Recording: return wordsOf({"info", "cat", "convert", "diff", "recover"});
        case Names::Level: return wordsOf({"Debug", "Info", "Warning", "Error", "Critical", "Fatal"});
        case Names::Format: return wordsOf({"text", "json"});
        case Names::Compression: return wordsOf({"zstd", "lz4", "none"});
        case Names::Deployment: {
            std::vector<Candidate> all;
            for (const Deployment& one : runningDeployments())
                all.push_back({one.name, "pid " + std::to_string(one.pid)});
            return all;
        }
        case Names::None:
        case Names::File: return {};
        default: return Running(given).names(kind, word);
    }
}

std::vector<Candidate> optionsOf(const Command* command) {
    std::vector<Candidate> all{{"--help", "explains it"}};
    if (command)
        for (const Option& option : command->options) all.push_back({"--" + keyOf(option), option.text});
    for (const Option& option : commonOptions()) all.push_back({"--" + keyOf(option), option.text});
    return all;
}

std::vector<Candidate> unfiltered(const std::vector<std::string>& words) {
    const Typed typed = understand(words);
    const std::string& last = words.back();
    if (typed.waiting) return namesOf(typed.waiting->completed, last, typed.given);
    if (!last.empty() && last[0] == '-')
        return typed.command && typed.command->program ? std::vector<Candidate>() : optionsOf(typed.command);
    if (!typed.command) {
        std::vector<Candidate> all;
        for (const Command& command : commands()) all.push_back({command.name, command.summary});
        return all;
    }
    const auto& arguments = typed.command->arguments;
    if (arguments.empty()) return {};
    const std::size_t index = std::min(typed.arguments, arguments.size() - 1);
    if (typed.arguments > index && arguments[index].most != kAny) return {};
    if (std::string(typed.command->name) == "man") {
        std::vector<Candidate> all;
        for (const Command& command : commands()) all.push_back({command.name, command.summary});
        return all;
    }
    return namesOf(arguments[index].names, last, typed.given);
}

}  // namespace

std::vector<Candidate> candidatesFor(const std::vector<std::string>& words) {
    if (words.empty()) return {};
    std::vector<Candidate> all;
    try {
        all = unfiltered(words);
    } catch (const std::exception&) {
        return {};  // a shell has no place for errors while a line is typed
    }
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const Candidate& one) { return !beginsWith(one.word, words.back()); }),
              all.end());
    return all;
}

std::string scriptOf(const std::string& shell) {
    if (shell == "bash")
        return R"(# Completion of oro for bash.
_oro() {
    local words=("${COMP_WORDS[@]:1:COMP_CWORD}") line
    COMPREPLY=()
    while IFS=$'\t' read -r line _; do
        printf -v line %q "$line"  # bash inserts it as it is
        COMPREPLY+=("$line")
    done < <(oro __complete "${words[@]}" 2> /dev/null)
    # Parts follow a component without a blank.
    [[ ${#COMPREPLY[@]} -gt 0 && ${COMPREPLY[0]} == *. ]] && compopt -o nospace
}
complete -o default -F _oro oro
)";
    if (shell == "zsh")
        return R"(#compdef oro
# Completion of oro for zsh.
_oro() {
    local -a ended open texts
    local word text
    while IFS=$'\t' read -r word text; do
        if [[ $word == *. ]]; then open+=("$word"); else ended+=("$word"); texts+=("$word${text:+  -- $text}"); fi
    done < <(oro __complete "${(@)words[2,CURRENT]}" 2> /dev/null)
    (( $#open )) && compadd -S '' -- $open
    (( $#ended )) && compadd -l -d texts -- $ended
    (( $#open + $#ended )) || _files
}
# Both as a file of fpath and by eval.
if [ "${funcstack[1]}" = "_oro" ]; then _oro "$@"; else compdef _oro oro; fi
)";
    if (shell == "fish")
        return R"(# Completion of oro for fish.
function __oro_words
    set -l words (commandline -opc) (commandline -ct)
    oro __complete $words[2..-1] 2> /dev/null
end
complete -c oro -f -a '(__oro_words)'
)";
    return {};
}

void writeCompletion(Session& session) {
    const std::string script = scriptOf(session.word(0));
    if (script.empty())
        throw Failure(Status::Usage,
                      "there is no completion for '" + session.word(0) + "'; expected bash, zsh or fish");
    session.out().write(script);
}

}  // namespace oroforge::live_client
