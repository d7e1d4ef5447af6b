// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ros_options.hpp"

#include <cstdlib>

#include <diag/nearest_match.hpp>

namespace oroforge::messages {

namespace {

const std::vector<std::string> kOptions = {"--messages",     "--services",       "--md5",          "--definition",
                                           "--dependencies", "--explain",        "--help",         "--version",
                                           "--output",       "--path",           "--include",      "--per-source",
                                           "--depfile",      "--depfile-target", "--list-outputs", "--format"};

struct Verb {
    const char* option;
    Command command;
};
constexpr Verb kVerbs[] = {{"--messages", Command::Messages},
                           {"--services", Command::Services},
                           {"--md5", Command::Md5},
                           {"--definition", Command::Definition},
                           {"--dependencies", Command::Dependencies},
                           {"--explain", Command::Explain},
                           {"--help", Command::Help},
                           {"-h", Command::Help},
                           {"--version", Command::Version}};

class Parser {
public:
    explicit Parser(diag::Sink& sink) : sink_(sink) {}

    RosOptions parse(const std::vector<std::string>& words) {
        for (std::size_t i = 0; i != words.size(); ++i) {
            std::string option = words[i];
            if (option.empty() || option[0] != '-') {
                options_.words.push_back(option);
                continue;
            }
            if (verb(option)) continue;
            if (option == "--list-outputs") {
                options_.listOutputs = true;
                continue;
            }
            std::string value;
            const std::size_t equals = option.find('=');
            if (option.compare(0, 2, "--") == 0 && equals != std::string::npos) {
                value = option.substr(equals + 1);
                option = option.substr(0, equals);
            } else if (i + 1 != words.size()) {
                value = words[++i];
            }
            take(option, value);
        }
        finish();
        return options_;
    }

private:
    void fail(const std::string& text) { sink_.error({"typegen-ros"}, "RM008", text); }

    bool verb(const std::string& option) {
        for (const Verb& one : kVerbs) {
            if (option != one.option) continue;
            if (hasVerb_) fail("'" + option + "' and another of --messages, --services, --md5 … exclude each other");
            hasVerb_ = true;
            options_.command = one.command;
            return true;
        }
        return false;
    }

    void take(const std::string& option, const std::string& value) {
        if (value.empty()) fail("option '" + option + "' needs a value" + diag::didYouMean(option, kOptions));
        if (option == "-o" || option == "--output") {
            options_.output = value;
        } else if (option == "--path") {
            const std::size_t equals = value.find('=');
            if (equals == std::string::npos || equals == 0)
                fail("'--path=" + value + "' is not '--path=PACKAGE=FOLDER'");
            else
                options_.paths.emplace_back(value.substr(0, equals), value.substr(equals + 1));
        } else if (option == "--include") {
            options_.includes.push_back(value);
        } else if (option == "--per-source") {
            options_.perSource = static_cast<std::size_t>(std::strtoul(value.c_str(), nullptr, 10));
            if (options_.perSource == 0) fail("'--per-source=" + value + "' is not a number of messages above 0");
        } else if (option == "--depfile") {
            options_.depfile = value;
        } else if (option == "--depfile-target") {
            options_.depfileTarget = value;
        } else if (option != "--format") {
            fail("invalid option '" + option + "'" + diag::didYouMean(option, kOptions));
        }
    }

    void finish() {
        const bool generates = options_.command == Command::Messages || options_.command == Command::Services;
        if (!hasVerb_) fail("nothing to do: no --messages, --services, --md5, --definition or --dependencies");
        if (generates && options_.words.empty()) fail("no package; see typegen-ros --help");
        if (options_.command == Command::Dependencies && options_.words.empty())
            fail("--dependencies needs the name of a package");
        if (generates && options_.output.empty()) fail("no output folder; add '-o FOLDER'");
    }

    diag::Sink& sink_;
    RosOptions options_;
    bool hasVerb_ = false;
};

}  // namespace

std::optional<RosOptions> parseRosOptions(const std::vector<std::string>& words, diag::Sink& sink) {
    RosOptions options = Parser(sink).parse(words);
    if (sink.hadErrors()) return std::nullopt;
    return options;
}

std::string rosUsage() {
    return
        R"(usage: typegen-ros --messages PACKAGE [FILE.msg...] -o DIR [options]
       typegen-ros --services PACKAGE [FILE.srv...] -o DIR [options]
       typegen-ros --md5 | --definition PACKAGE/NAME...
       typegen-ros --dependencies PACKAGE [FILE...]

Makes the source of a typekit for the messages of a ROS package, and of its transport; or of the plugin for its services.
Without files those of the package are taken. Packages are found in ROS_PACKAGE_PATH, CMAKE_PREFIX_PATH and /usr/share.

  -o, --output=DIR          where to generate
      --path=PACKAGE=DIR    DIR has .msg files of PACKAGE; may be repeated, and comes before what is found
      --include=HEADER      all sources include <HEADER>; may be repeated
      --per-source=NUMBER   so many messages in each source file
      --list-outputs        print the names of the files that would be written, and do nothing else
      --depfile=FILE        write the names of all files that were read, for make or ninja
      --depfile-target=FILE what depends on them; default all files that are generated
      --md5, --definition   print the md5 sum or the complete definition of messages; --md5 also of services
      --dependencies        print the other packages whose messages are in those of PACKAGE
      --format=text|json|sarif
                            how errors and warnings are told: text on standard error, or a document on standard output
      --explain [CODE...]   print what these codes mean
      --version, -h, --help
)";
}

}  // namespace oroforge::messages
