// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <exception>
#include <iostream>

#include <diag/print.hpp>
#include <driver/commands.hpp>
#include <driver/kinds.hpp>
#include <render/renderer.hpp>
#include <explain/explanations.hpp>
#include <report/report.hpp>

namespace oroforge::embedded {
diag::EmbeddedFiles componentTemplates();
}

namespace {

using namespace oroforge;

void work(const driver::Options& options, std::ostream& out, diag::Sink& sink) {
    if (options.explain) return explain::explanations().print(options.words, {"orocreate-pkg", "OC001"}, out, sink);
    try {
        render::Templates templates(embedded::componentTemplates());
        if (!options.templateDir.empty() && !templates.overrideFrom(options.templateDir, sink)) return;
        if (options.list) return driver::listKinds(templates, out);
        if (options.upgrade) return driver::upgradePackages(options, out, sink);
        const render::Renderer renderer(templates);
        if (!options.add.empty()) {
            driver::addPart(options, renderer, out, sink);
        } else if (options.describe) {
            driver::describeComponents(options, out, sink);
        } else if (options.update) {
            driver::updatePackage(options, renderer, out, sink);
        } else if (options.generate.empty()) {
            driver::createPackage(options, renderer, out, sink);
        } else {
            driver::generateComponents(options, renderer, out, sink);
        }
    } catch (const render::RenderError& error) {
        sink.error({"orocreate-pkg", 0, 0}, "OC007", std::string("template ") + error.what());
    } catch (const std::exception& failure) {
        sink.error({"orocreate-pkg"}, "OC042",
                   std::string("stopped by a failure that was not expected: ") + failure.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto format = report::wantedFormat({argv + 1, argv + argc});
    diag::Sink sink;
    int status = 0;
    const auto options = driver::parseOptions(argc, argv, sink, status);
    // A document for programs has standard output to itself.
    if (options) work(*options, format == report::Format::Text ? std::cout : std::cerr, sink);
    const bool toldOnly = !options && status == 0;  // --help, --version
    const bool written =
        toldOnly || report::write(format, {"orocreate-pkg", OROFORGE_VERSION, &explain::explanations()}, sink,
                                  std::cout, std::cerr);
    const bool arrived = diag::arrived(std::cout, std::cerr, "orocreate-pkg", "EMIT004");
    return !written || !arrived || sink.hadErrors() ? 1 : status;
}
