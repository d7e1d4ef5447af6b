// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any header goes through all of typegen, in this process: a model that can be rendered, or errors with their places. Parts of
// the input are told apart by lines: "//--- adapters" begins an adapter file, "//--- new" a second version of the header.
#include "fuzzing.hpp"

#include <adapters/read_adapters.hpp>
#include <clang/types/type_reader.hpp>
#include <collect/close_model.hpp>
#include <collect/header_inputs.hpp>
#include <diff/compare_models.hpp>
#include <diff/tell_changes.hpp>
#include <plan/typekit_files.hpp>
#include <plan/typekit_view.hpp>
#include <report/report.hpp>

#include "typegen/scratch_folder.hpp"
#include "typegen/source_check.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

using namespace oroforge;
using fuzz::ScratchFolder;

namespace oroforge::embedded {
diag::EmbeddedFiles typekitTemplates();
}

namespace {

struct Parts {
    std::string header, adapters, newer;
    bool hasAdapters = false, hasNewer = false;
};

Parts split(const std::string& text) {
    const std::string adapters = "//--- adapters\n", newer = "//--- new\n";
    Parts parts;
    std::string rest = text;
    if (const std::size_t at = rest.find(newer); at != std::string::npos) {
        parts.newer = rest.substr(at + newer.size());
        parts.hasNewer = true;
        rest.resize(at);
    }
    if (const std::size_t at = rest.find(adapters); at != std::string::npos) {
        parts.adapters = rest.substr(at + adapters.size());
        parts.hasAdapters = true;
        rest.resize(at);
    }
    parts.header = rest;
    return parts;
}

struct Version {
    std::string path, text;
};

void checkPlace(const diag::Location& where, const Version& header) {
    if (where.file.str() != header.path) return;
    const auto lines = static_cast<std::size_t>(std::count(header.text.begin(), header.text.end(), '\n')) + 1;
    // A line that is continued, or ends in another way, counts for the compiler as well.
    require(where.line <= lines + static_cast<std::size_t>(std::count(header.text.begin(), header.text.end(), '\r')),
            "places lie in the file", std::to_string(where.line));
    require(where.column <= header.text.size() + 1, "columns lie in the file", std::to_string(where.column));
}

void checkDiagnostics(const diag::Sink& sink, const Version& header) {
    for (const diag::Diagnostic& one : sink.all()) {
        require(!one.message.empty(), "diagnostics say something", one.code);
        require(one.code != "TK006" && one.code != "TK007" && one.code != "TK009", "nothing fails by itself",
                one.message);
        checkPlace(one.where, header);
        for (const diag::Note& note : one.notes) checkPlace(note.where, header);
        for (const diag::Fix& fix : one.fixes) {
            require(!(fix.end < fix.begin), "fixes end behind their begin", one.message);
            checkPlace(fix.end, header);
        }
    }
    const report::Tool tool{"typegen", "1"};
    for (const std::string& document : {report::jsonReport(tool, sink), report::sarifReport(tool, sink)})
        require(nlohmann::json::accept(document), "reports are JSON", document);
}

std::optional<model::TypeModel> read(const Version& header, const std::vector<adapters::Adapter>& adapters) {
    diag::Sink sink;
    cxx::ParseRequest request;
    request.flags = {"-include", FUZZ_SMALL_STD};
    request.headers = typekit::findHeaders({header.path}, request.flags, "fuzz", sink);
    request.adapters = adapters;
    auto model = cxx::readTypes(request, sink);
    require(model.has_value() != sink.hadErrors(), "there is a model or an error");
    if (model) typekit::closeModel(*model, sink);
    checkDiagnostics(sink, header);
    if (sink.hadErrors()) model.reset();
    return model;
}

void checkRendered(const model::TypeModel& model) {
    require(nlohmann::json::accept(dump(model)), "models can be dumped");
    static const render::Renderer renderer{render::Templates(embedded::typekitTemplates())};
    const emit::Outputs outputs = typekit::renderTypekit(typekit::makeView(model, "fuzz"), renderer);
    require(outputs.size() == typekit::outputNames("fuzz", model.headers).size(), "all files are written");
    for (const auto& [name, text] : outputs) fuzz::checkSource(text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static ScratchFolder folder;
    const Parts parts = split(std::string(reinterpret_cast<const char*>(data), size));
    std::vector<std::string> files;
    diag::Sink sink;
    if (parts.hasAdapters) files.push_back(folder.write("adapters.xml", parts.adapters));
    const auto adapters = adapters::readAdapters(files, sink);
    if (sink.hadErrors()) return 0;
    const auto model = read({folder.write("types.hpp", parts.header), parts.header}, adapters);
    if (!model) return 0;
    checkRendered(*model);
    require(typekit::compareModels(*model, *model).empty(), "nothing differs from itself");
    if (!parts.hasNewer) return 0;
    const auto newer = read({folder.write("newer.hpp", parts.newer), parts.newer}, adapters);
    if (!newer) return 0;
    const auto changes = typekit::compareModels(*model, *newer);
    const auto back = typekit::compareModels(*newer, *model);
    require(changes.empty() == back.empty(), "a change is one in both directions");
    typekit::tellChanges(changes, sink);
    require(sink.all().size() == changes.size(), "each change is told");
    return 0;
}
