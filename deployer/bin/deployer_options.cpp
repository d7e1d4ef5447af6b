// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deployer_options.hpp"

#include "../deployment/component_name.hpp"
#include "option_values.hpp"
#include "real_time_memory.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

namespace po = boost::program_options;
namespace diag = oroforge::diag;

namespace OCL::deploy {
namespace {

enum class Takes { Nothing, Word, Number, Words, PerhapsWord };

const struct {
    const char* name;
    Takes value;
    const char* text;
} kOptions[] = {
    {"help,h", Takes::Nothing, "show this text"},
    {"version", Takes::Nothing, "show the version"},
    {"explain", Takes::Nothing,
     "explain the codes that follow, such as the DEP031 in 'error: [DEP031]'; none = list them all"},
    {"start,s", Takes::Words, "deploy from this XML file (.xml, .cpf) or script (.ops, .osd, .lua); may be repeated"},
    {"site-file", Takes::Word, "deploy from this file first; default: <name>-site.cpf, if there is one"},
    {"log-level,l", Takes::Word,
     "Never, Fatal, Critical, Error, Warning, Info, Debug or RealTime; overrides ORO_LOGLEVEL"},
    {"log-time", Takes::Word,
     "relative: lines of the log begin with seconds since the start; wall: with local date and time; overrides "
     "ORO_LOGTIME"},
    {"no-consolelog", Takes::Nothing, "write the log to its file only"},
    {"check", Takes::Nothing,
     "check scripts without running them, load and configure what XML files describe, start nothing, clean up and end"},
    {"dry-run", Takes::Nothing,
     "check everything that files and installed libraries can tell, create nothing that XML files describe, and end"},
    {"strict", Takes::Nothing,
     "fail a script statement if an operation of the deployer, such as connect(), returns false and the script ignores "
     "the result; without the option this is a warning"},
    {"lenient", Takes::Nothing,
     "leave out text behind numbers in XML and property files, with a warning; without the option this is an error"},
    {"format", Takes::Word,
     "how errors and warnings are reported: text, or json or sarif, a document on standard output at the end"},
    {"dot", Takes::Word, "write the graph of the components to this file, for Graphviz"},
    {"rt-check", Takes::Nothing,
     "tell at the end what components with a real-time scheduler allocated, locked or waited for in updateHook(); then "
     "the exit status is 255"},
    {"replay", Takes::Word,
     "replay this recording (.mcap) in simulated time: components that only sent what it has are replaced; end when it "
     "has ended"},
    {"replace", Takes::Word,
     "which components are replaced in the replay, such as camera,imu; without it, those that only sent what it has"},
    {"record", Takes::Word,
     "record what the components of the replay send to this file; the same replay gives the same bytes"},
    {"replay-speed", Takes::Word,
     "how fast simulated time passes, such as 1 for real time or 0.5; without it, as fast as possible"},
    {"tolerate", Takes::Nothing,
     "replay messages whose type has other fields now: what was not recorded keeps its default"},
    {"replay-check", Takes::Nothing,
     "tell at the end which components use the wall clock, random numbers or devices, sleep or have threads of their "
     "own, so that a replay is not exact; then the exit status is 255"},
    {"log4cpp-config", Takes::Word,
     "configure log4cpp by this property file before anything is deployed: levels of categories, and appenders of "
     "log4cpp"},
    {"rtt-log4cpp-config-file", Takes::Word, "the same, by its former name"},
    {"daemon,d", Takes::Nothing, "run in the background, without the console"},
    {"lock-memory", Takes::Nothing,
     "keep all memory of the process in RAM (mlockall); where that is not allowed, a warning says so, and the program "
     "goes on"},
    {"minNumberCPU", Takes::Number, "end with exit status 254 if this process has fewer processors"},
    {"require-name-service", Takes::Nothing,
     "fail without a naming service that takes the names; only for programs with CORBA, such as cdeployer"},
    {"rtalloc-mem-size", Takes::Word, "size of the pool of real-time memory, with k, m or g for units; default: 512k"},
    {"max-elements", Takes::Number,
     "how many elements scripts may ask for at once, as 'var array a(100)' does; default: 10000000"},
    {"no-live", Takes::Nothing, "no socket by which 'oro' of the same user looks at the deployment"},
    {"web", Takes::PerhapsWord,
     "let Foxglove, Lichtblick and 'oro' look at the deployment at ADDRESS:PORT and print the URL; default: "
     "127.0.0.1:8765"},
    {"web-allow", Takes::Word,
     "what they may do there besides looking, such as properties,operations,lifecycle: set properties, call "
     "operations, "
     "start and stop components"},
    {"web-origin", Takes::Word,
     "sites whose pages may connect there besides those of this computer and app.foxglove.dev, such as "
     "https://view.example,http://10.0.0.5:8080"},
    {"web-token-file", Takes::Word,
     "a file with the token that they must know, which only its owner may read; without it, each run has another "
     "token"},
    {"DeployerName", Takes::Words, "name of the deployer; the option's name may be left out"},
};

// Indexed by level.
const char* const kLevels[] = {"Never", "Fatal", "Critical", "Error", "Warning", "Info", "Debug", "RealTime"};

po::options_description visibleOptions() {
    po::options_description options("Options");
    for (const auto& option : kOptions) {
        switch (option.value) {
            case Takes::Nothing: options.add_options()(option.name, option.text); break;
            case Takes::PerhapsWord:
                options.add_options()(option.name, po::value<std::string>()->implicit_value("127.0.0.1:8765"),
                                      option.text);
                break;
            case Takes::Word: options.add_options()(option.name, po::value<std::string>(), option.text); break;
            case Takes::Number: options.add_options()(option.name, po::value<int>(), option.text); break;
            case Takes::Words:
                options.add_options()(option.name, po::value<std::vector<std::string>>()->composing(), option.text);
                break;
        }
    }
    return options;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/** The level of that name, −1 if there is none. */
int logLevelOf(const std::string& name) {
    for (int level = RTT::Never; level <= RTT::RealTime; ++level)
        if (lower(name) == lower(kLevels[level])) return level;
    return -1;
}

const std::vector<std::string> kFileKinds = {"xml", "cpf", "ops", "osd", "lua"};

bool isScript(const std::string& word) {
    return std::any_of(kFileKinds.begin(), kFileKinds.end(),
                       [&](const std::string& kind) { return word.find('.' + kind) != std::string::npos; });
}

/** True if the word looks like the name of a file rather than of a component. */
bool looksLikeFile(const std::string& word) {
    if (word.find('/') != std::string::npos || word == "." || word == "..") return true;
    const std::size_t dot = word.rfind('.');
    if (dot == std::string::npos) return false;
    std::error_code none;
    return diag::nearestMatch(word.substr(dot + 1), kFileKinds) || std::filesystem::is_regular_file(word, none);
}

/** True for remappings and parameters, which ROS launch files add to every command line. */
bool isForRos(const std::string& word) { return word[0] == '_' || word.find(":=") != std::string::npos; }

/** Commands of other programs, and what does the same here. */
const struct {
    std::vector<std::string> words;
    const char* instead;
} kCommands[] = {
    {{"list", "ls", "show", "info", "status", "ps"}, "'ls' at the console tells what there is"},
    {{"run", "launch", "deploy", "load", "exec"}, "'-s FILE' deploys a file"},
    {{"stop", "quit", "exit", "kill"}, "the signal SIGTERM, or 'quit' at its console, ends a deployer"},
};

/** What to write instead of a command of that name; empty if there is no such command. */
std::string insteadOfCommand(const std::string& word) {
    for (const auto& command : kCommands)
        if (std::find(command.words.begin(), command.words.end(), word) != command.words.end()) return command.instead;
    return "";
}

bool isOptionName(const std::string& word) {
    return std::any_of(std::begin(kOptions), std::end(kOptions), [&](const auto& option) {
        const std::string name = option.name;
        return name.substr(0, name.find(',')) == word;
    });
}

/** The names given by --DeployerName. */
std::vector<std::string> namesByOption(const po::parsed_options& parsed) {
    std::vector<std::string> names;
    for (const po::option& option : parsed.options)
        if (option.string_key == "DeployerName" && option.position_key < 0)
            names.insert(names.end(), option.value.begin(), option.value.end());
    return names;
}

/** Takes the words without an option: files, and the name of the deployer. Remappings of ROS launch files are
    ignored. */
void takeWords(const std::vector<std::string>& words, const std::vector<std::string>& names, Options& options,
               std::string& error) {
    std::string name;
    for (const std::string& word : words) {
        if (word.empty() || isForRos(word)) continue;
        if (isScript(word)) {
            options.files.push_back(word);
        } else if (looksLikeFile(word)) {
            error = "'" + word +
                    "' is neither a file to deploy, which ends in .xml, .cpf, .ops, .osd or .lua, nor a name for the "
                    "deployer";
        } else if (const std::string why = nameFault(word); !why.empty()) {
            error = "'" + printableName(word) + "' is no name for the deployer: " + why;
        } else if (const bool meant = std::find(names.begin(), names.end(), word) != names.end();
                   !meant && isOptionName(word)) {
            error = "'" + word + "' would be the name of the deployer; did you mean '--" + word +
                    "'? If it is to have that name, write '--DeployerName=" + word + "'";
        } else {
            if (const std::string instead = insteadOfCommand(word); !meant && !instead.empty())
                options.warning = "'" + word + "' is no command, but is now the name of the deployer; " + instead;
            if (!name.empty() && word != name)
                options.warning = "two names for the deployer, '" + name + "' and '" + word + "': the last one counts";
            options.name = name = word;
        }
    }
}

const std::vector<std::string> kLogTimes = {"relative", "wall"};

void takeLogTime(const std::string& value, Options& options, std::string& error) {
    const auto found = std::find(kLogTimes.begin(), kLogTimes.end(), value);
    if (found == kLogTimes.end())
        error = "unknown value '" + value + "' of --log-time, expected " + diag::oneOf(kLogTimes) +
                diag::didYouMean(value, kLogTimes);
    else
        options.logTime = value == "wall" ? RTT::LogTime::Wall : RTT::LogTime::Relative;
}

bool takeValues(const po::variables_map& values, const std::vector<std::string>& names, Options& options,
                std::string& error) {
    options.action = values.count("help")      ? Options::ShowHelp
                     : values.count("version") ? Options::ShowVersion
                     : values.count("explain") ? Options::Explain
                                               : Options::Run;
    if (values.count("start")) options.files = values["start"].as<std::vector<std::string>>();
    if (std::find(options.files.begin(), options.files.end(), "") != options.files.end())
        error = "the name of a file is empty";
    if (values.count("DeployerName")) {
        const auto& words = values["DeployerName"].as<std::vector<std::string>>();
        if (options.action == Options::Explain)
            options.codes = words;
        else
            takeWords(words, names, options, error);
    }
    if (values.count("site-file")) options.siteFile = values["site-file"].as<std::string>();
    options.consoleLog = !values.count("no-consolelog");
    options.check = values.count("check") != 0;
    options.dryRun = values.count("dry-run") != 0;
    options.strict = values.count("strict") != 0;
    options.lenient = values.count("lenient") != 0;
    for (const char* name : {"rtt-log4cpp-config-file", "log4cpp-config"})
        if (values.count(name)) options.categoryFile = values[name].as<std::string>();
    if ((values.count("log4cpp-config") || values.count("rtt-log4cpp-config-file")) && options.categoryFile.empty())
        error = "the name of the property file for log4cpp is empty";
    if (values.count("dot")) options.graphFile = values["dot"].as<std::string>();
    if (values.count("format")) {
        const std::string format = values["format"].as<std::string>();
        const auto known = oroforge::report::formatOf(format);
        options.format = known.value_or(oroforge::report::Format::Text);
        if (!known)
            error = "unknown value '" + format + "' of --format, expected " +
                    diag::oneOf(oroforge::report::formatNames()) +
                    diag::didYouMean(format, oroforge::report::formatNames());
    }
    options.daemon = values.count("daemon") != 0 && !options.endsAtOnce();
    options.realTimeCheck = values.count("rt-check") != 0;
    options.requireNameService = values.count("require-name-service") != 0;
    options.lockMemory = values.count("lock-memory") != 0;
    if (options.realTimeCheck && options.endsAtOnce())
        error = "--rt-check watches components that run, which --check and --dry-run do not start";
    if (values.count("rtalloc-mem-size")) {
        const std::string size = values["rtalloc-mem-size"].as<std::string>();
        options.realTimeMemory = parseMemorySize(size);
        if (options.realTimeMemory == 0) error = "no size of real-time memory: '" + size + "'";
    }
    if (values.count("minNumberCPU")) {
        options.minimumProcessors = values["minNumberCPU"].as<int>();
        if (options.minimumProcessors < 0)
            error = "no number of processors: " + std::to_string(options.minimumProcessors);
    }
    if (values.count("max-elements")) {
        const int elements = values["max-elements"].as<int>();
        if (elements > 0)
            options.maxElements = static_cast<std::size_t>(elements);
        else
            error = "no number of elements: " + std::to_string(elements);
    }
    takeReplay(values, options, error);
    takeLive(values, options, error);
    if (values.count("log-time")) takeLogTime(values["log-time"].as<std::string>(), options, error);
    if (!values.count("log-level")) return error.empty();
    const std::string level = values["log-level"].as<std::string>();
    options.logLevel = logLevelOf(level);
    if (options.logLevel < 0)
        error = "unknown log level '" + level + "', expected " + diag::oneOf({std::begin(kLevels), std::end(kLevels)});
    return error.empty();
}

std::string likelyOption(const std::string& given) {
    std::vector<std::string> known;
    for (const auto& option : kOptions) {
        const std::string name = option.name;
        known.push_back("--" + name.substr(0, name.find(',')));
    }
    return diag::didYouMean(given, known);
}

}  // namespace

bool parseOptions(int argc, char** argv, Options& options, std::string& error) {
    std::vector<std::string> words(argv + 1, argv + argc);
    words.erase(std::find(words.begin(), words.end(), "--"), words.end());  // words after it are for the runtime
    try {
        po::positional_options_description positions;
        positions.add("DeployerName", -1);
        po::variables_map values;
        // The parsed words refer to it.
        const po::options_description known = visibleOptions();
        const po::parsed_options parsed = po::command_line_parser(words).options(known).positional(positions).run();
        po::store(parsed, values);
        po::notify(values);
        return takeValues(values, namesByOption(parsed), options, error);
    } catch (const po::unknown_option& thrown) {
        error = thrown.what() + likelyOption(thrown.get_option_name());
        return false;
    } catch (const po::error& thrown) {
        error = thrown.what();
        return false;
    }
}

std::string usage(const std::string& program, const ProgramText& text) {
    std::ostringstream all;
    all << "Usage: " << program << " [options] [name] [file…] [-- options of the runtime]\n\n"
        << text.purpose << "\nExit status: 0, or 255 if a file could not be deployed.\n\n"
        << "Example: " << program << " -s application.xml\n\n"
        << visibleOptions();
    return all.str();
}

std::string version(const std::string& program) {
    return program + " " ORO_STRINGIFY(RTT_VERSION) " (Oroforge, target " OROCOS_TARGET_NAME ", compiler " __VERSION__
                                                    ")\n";
}

std::string partName(const std::string& program) {
    const std::string name = std::filesystem::path(program).filename().string(), target = "-" OROCOS_TARGET_NAME;
    const std::size_t at = name.rfind(target);
    return at != std::string::npos && at != 0 && at + target.size() == name.size() ? name.substr(0, at) : name;
}

std::string programVersion() { return ORO_STRINGIFY(RTT_VERSION); }

std::vector<char*> wordsForRuntime(int argc, char** argv) {
    std::vector<char*> words(argv, argv + argc);
    const auto separator =
        std::find_if(words.begin(), words.end(), [](const char* word) { return std::string(word) == "--"; });
    if (separator != words.end()) words.erase(words.begin() + 1, separator + 1);
    words.push_back(nullptr);
    return words;
}

}  // namespace OCL::deploy
