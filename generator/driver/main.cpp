// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <iostream>

#include <diag/print.hpp>
#include <driver/create.hpp>
#include <render/renderer.hpp>

namespace oroforge::render {
EmbeddedFiles componentTemplates();
}

namespace {

using namespace oroforge;

void work(const driver::Options& options, diag::Sink& sink) {
    render::Templates templates(render::componentTemplates());
    if (!options.templateDir.empty() && !templates.overrideFrom(options.templateDir, sink)) return;
    const render::Renderer renderer(templates);
    try {
        if (options.generate.empty()) {
            driver::createPackage(options, renderer, std::cout, sink);
        } else {
            driver::generateComponents(options, renderer, std::cout, sink);
        }
    } catch (const render::RenderError& error) {
        sink.error({"orocreate-pkg", 0, 0}, "OC007", std::string("template ") + error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    diag::Sink sink;
    int status = 0;
    if (const auto options = driver::parseOptions(argc, argv, sink, status)) work(*options, sink);
    diag::print(std::cerr, sink);
    return sink.hadErrors() ? 1 : status;
}
