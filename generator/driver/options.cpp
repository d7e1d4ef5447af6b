// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/options.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include <diag/nearest_match.hpp>
#include <driver/compiler_words.hpp>
#include <report/report.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

constexpr const char* kUsage =
    "Makes a package of components.\n"
    "\n"
    "  orocreate-pkg NAME [KIND...]           a new package in ./NAME from skeletons\n"
    "  orocreate-pkg NAME --from MANIFEST     a new package in ./NAME with what MANIFEST describes\n"
    "  orocreate-pkg --add KIND NAME          one more part in the package of the current directory\n"
    "  orocreate-pkg --generate MANIFEST --output DIR [--check]\n"
    "                                         the base classes alone; what the package's build calls\n"
    "  orocreate-pkg --update [MANIFEST] [--dry-run | --check] [-I DIR] [-D MACRO]\n"
    "                                         the classes of an existing package follow its manifest\n"
    "  orocreate-pkg --upgrade DIR...         manifest.xml of packages of the original toolchain\n"
    "  orocreate-pkg --describe FILE... [-o MANIFEST] [-I DIR] [-D MACRO] [-std=STANDARD] [-p DIR]\n"
    "                                         the manifest of component classes that were written by hand\n"
    "  orocreate-pkg --list                   the kinds, and the templates that can be replaced\n"
    "  orocreate-pkg --explain [CODE...]      what a code means, as the OM003 in \"error: [OM003] ...\"; none = list "
    "them\n"
    "\n"
    "Kinds, any number of them, none = all: component plugin service support typekit application topics;\n"
    "cmake (only the build files), empty (only package.xml).\n";

const std::string kCreate = "a new package";

constexpr const char* kHelpHint = "orocreate-pkg --help explains the command line";

void declare(CLI::App& app, Options& options) {
    app.add_option("words", options.words, "Name of the package, then its kinds")->type_name("NAME [KIND...]");
    app.add_option("--add", options.add, "Add a part to the package of the current directory")
        ->type_name("KIND NAME")
        ->expected(2);
    app.add_option("--namespace", options.nameSpace, "Namespace of the classes")->type_name("A::B");
    app.add_option("--class", options.className, "Name of the component's class; else that of the package")
        ->type_name("CLASS");
    app.add_option("--license", options.license, "License of the new package, as package.xml names it")
        ->type_name("NAME");
    app.add_option("--author", options.authors, "Author of the new package, any number of times")
        ->type_name("\"NAME <MAIL>\"")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_flag("--dry-run", options.dryRun, "Print what would be written, and write nothing");
    app.add_flag("--list", options.list, "Print the kinds and the templates");
    app.add_flag("--catkin", options.catkin, "For a catkin workspace; orocreate-catkin-pkg does so by itself");
    app.add_flag("--upgrade", options.upgrade, "Change manifest.xml of packages so that rosdep finds the toolchain");
    app.add_flag("--check", options.check,
                 "With --generate, --update: write nothing, fail if a file is missing or stale");
    app.add_flag("--update", options.update, "Bring the classes of the user up to date with the manifest");
    const auto addNames = [&](const char* name, std::vector<std::string>& into, const char* type, const char* help) {
        app.add_option(name, into, help)
            ->type_name(type)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    addNames("--take-manifest", options.takeManifest, "NAME", "With --update: change the code, as the manifest has it");
    addNames("--take-code", options.takeCode, "NAME", "With --update: leave the code as it is");
    app.add_option("--from", options.from, "Component manifest (XML) of the new package")->type_name("MANIFEST");
    app.add_option("--generate", options.generate, "Component manifest to generate base classes from")
        ->type_name("MANIFEST");
    app.add_option("-o,--output", options.output, "Directory for generated files")->type_name("DIR");
    app.add_flag("--list-outputs", options.listOutputs, "Print the files that --generate would write, and stop");
    app.add_option("--depfile", options.depfile, "Also write dependencies for make or ninja")->type_name("FILE");
    app.add_option("--depfile-target", options.depfileTarget, "What it is about, instead of the generated files")
        ->type_name("FILE");
    app.add_option("--template-dir", options.templateDir, "Templates here replace the built-in ones of the same name")
        ->type_name("DIR");
    app.add_option("--dump", options.dump, "Print an intermediate step of --generate as JSON: model or view")
        ->check(CLI::IsMember({"model", "view"}));
    app.add_option("--format", options.format, "Form of errors and warnings: text, json or sarif")
        ->check(CLI::IsMember(report::formatNames()));
    app.add_flag("--explain", options.explain, "Print what these codes of errors mean; without any list them all");
    app.add_flag("-f,--force", options.force,
                 "Write into an existing directory; sources there are kept, build files are kept as *.old");
    app.add_flag("--describe", options.describe, "Read headers and sources, print the manifest of their components");
    app.add_option("--package", options.package, "With --describe: the package's name; else that of the folder")
        ->type_name("NAME");
    app.add_option("-p,--compile-database", options.database, "Take options of the compiler from compile_commands.json")
        ->type_name("FILE|DIR");
    app.add_option("--compile-database-for", options.databaseEntry, "From the entry of this source or target")
        ->type_name("SOURCE|TARGET");
    app.set_version_flag("--version", "orocreate-pkg (Oroforge) " OROFORGE_VERSION);
}

std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    }
    return names;
}

/// Returns the faults of the command line, one text each.
std::vector<std::string> wordings(const CLI::App& app, const CLI::ParseError& error) {
    std::vector<std::string> texts;
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        for (const std::string& word : app.remaining()) {
            texts.push_back("unknown option '" + word + "'" + diag::didYouMean(word, optionNames(app)));
        }
    } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        const std::string text = error.what();
        texts.push_back("option '" + text.substr(0, text.find(':')) + "' needs a value");
    } else {
        texts.push_back(std::string("cannot use the command line: ") + error.what());
    }
    return texts;
}

/// Returns the jobs that were asked for; without such an option the program makes a package.
std::vector<std::string> modesOf(const Options& options) {
    std::vector<std::string> modes;
    const auto add = [&](bool given, const char* name) {
        if (given) modes.push_back(name);
    };
    add(options.explain, "--explain");
    add(options.list, "--list");
    add(options.upgrade, "--upgrade");
    add(options.update, "--update");
    add(!options.add.empty(), "--add");
    add(!options.generate.empty(), "--generate");
    add(options.describe, "--describe");
    if (modes.empty()) modes.push_back(kCreate);
    return modes;
}

/// An option, whether it was given, and the jobs that take it.
struct Use {
    const char* option;
    bool given;
    std::vector<std::string> modes;
};

std::vector<Use> usesOf(const Options& options) {
    const std::string generate = "--generate", describe = "--describe";
    return {
        {"--from", !options.from.empty(), {kCreate}},
        {"--output", !options.output.empty(), {generate, describe}},
        {"--list-outputs", options.listOutputs, {generate}},
        {"--depfile", !options.depfile.empty(), {generate}},
        {"--depfile-target", !options.depfileTarget.empty(), {generate}},
        {"--dump", !options.dump.empty(), {generate}},
        {"--check", options.check, {generate, "--update"}},
        {"--take-manifest", !options.takeManifest.empty(), {"--update"}},
        {"--take-code", !options.takeCode.empty(), {"--update"}},
        {"--template-dir", !options.templateDir.empty(), {kCreate, "--add", generate, "--list", "--update"}},
        {"--namespace", !options.nameSpace.empty(), {kCreate, "--add"}},
        {"--class", !options.className.empty(), {kCreate, "--add"}},
        {"--license", !options.license.empty(), {kCreate}},
        {"--author", !options.authors.empty(), {kCreate}},
        {"--catkin", options.catkin, {kCreate}},
        {"--dry-run", options.dryRun, {kCreate, "--add", "--upgrade", "--update"}},
        {"--force", options.force, {kCreate, "--upgrade"}},
        {"--package", !options.package.empty(), {describe}},
        {"--compile-database", !options.database.empty(), {describe}},
        {"--compile-database-for", !options.databaseEntry.empty(), {describe}},
    };
}

/// Reports options that exclude each other.
void checkCombination(const Options& options, diag::Sink& sink) {
    const diag::Location here{"orocreate-pkg", 0, 0};
    const auto complain = [&](bool wrong, const std::string& text) {
        if (wrong) sink.error(here, "OC001", text).hint(kHelpHint);
    };
    const std::vector<std::string> modes = modesOf(options);
    complain(modes.size() > 1, modes.front() + " and " + modes.back() + " exclude each other");
    if (modes.size() > 1) return;
    const std::string& mode = modes.front();
    for (const Use& use : usesOf(options)) {
        const bool fits = std::find(use.modes.begin(), use.modes.end(), mode) != use.modes.end();
        complain(use.given && !fits, std::string(use.option) + (mode == kCreate ? " needs " + use.modes.front()
                                                                                : " does not go with " + mode));
    }
    complain(options.explain && options.format != "text", "--explain prints text, so it takes no --format");
    complain(options.format != "text" && (options.listOutputs || !options.dump.empty()),
             "--format excludes --list-outputs and --dump: both write to standard output");
    if (mode == kCreate) {
        const bool fromManifest = !options.from.empty();
        complain(options.words.empty() && !fromManifest,
                 "no package name given, expected orocreate-pkg NAME [KIND...]");
        complain(fromManifest && options.words.size() > 1,
                 "--from and kinds exclude each other: the manifest says what the package contains");
        const bool described = !options.nameSpace.empty() || !options.className.empty() || !options.license.empty() ||
                               !options.authors.empty();
        complain(fromManifest && described,
                 "--from excludes --namespace, --class, --license and --author: the manifest says them");
    } else if (mode == "--generate") {
        complain(!options.words.empty(), "--generate takes no package name");
        complain(options.output.empty() && options.dump.empty(), "--generate needs --output DIR");
    } else if (mode == "--add" || mode == "--list") {
        complain(!options.words.empty(),
                 mode + " takes no package name, found '" + (options.words.empty() ? "" : options.words.front()) + "'");
    } else if (mode == "--describe") {
        complain(options.words.empty(), "--describe needs headers or sources");
        complain(!options.databaseEntry.empty() && options.database.empty(),
                 "--compile-database-for says which entry, but no --compile-database");
        complain(options.format != "text" && options.output.empty(),
                 "--format excludes --describe without --output: both write to standard output");
    } else if (mode == "--update") {
        complain(options.words.size() > 1, "--update takes one manifest");
    } else if (mode == "--upgrade") {
        complain(options.words.empty(), "--upgrade needs the folders of packages");
    }
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv, diag::Sink& sink, int& status) {
    Options options;
    CLI::App app(kUsage, "orocreate-pkg");
    app.set_help_flag("-h,--help", "Print this and stop");
    declare(app, options);
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    // Other modes do not take compiler options, and report them.
    const bool compiles = std::any_of(
        words.begin(), words.end(), [](const std::string& word) { return word == "--describe" || word == "--update"; });
    if (compiles) options.flags = takeCompilerWords(words);
    std::reverse(words.begin(), words.end());
    try {
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            status = app.exit(error);
            return std::nullopt;
        }
        for (const std::string& text : wordings(app, error))
            sink.error({"orocreate-pkg", 0, 0}, "OC001", text).hint(kHelpHint);
    }
    const std::string program = argc > 0 ? fs::path(argv[0]).filename().string() : "";
    const bool anyMode = modesOf(options).front() != kCreate;
    if (program.find("catkin") != std::string::npos && !anyMode) options.catkin = true;
    if (!sink.hadErrors()) checkCombination(options, sink);
    if (!sink.hadErrors()) return options;
    status = 1;
    return std::nullopt;
}

}  // namespace oroforge::driver
