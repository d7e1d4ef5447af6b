// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "golden_typekit.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <fstream>

#include <adapters/read_adapters.hpp>
#include <clang/type_reader.hpp>
#include <collect/close_model.hpp>
#include <collect/header_inputs.hpp>
#include <driver/options.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

namespace fs = std::filesystem;

namespace oroforge::test {

namespace {

std::vector<std::string> wordsOf(const fs::path& dir) {
    std::vector<std::string> words;
    std::ifstream file(dir / "args");
    for (std::string line; std::getline(file, line);) words.push_back(line);
    return words;
}

void load(const std::string& file) {
    void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << ::dlerror();
    const auto loadPlugin = reinterpret_cast<bool (*)(void*)>(::dlsym(library, "loadRTTPlugin"));
    ASSERT_NE(loadPlugin, nullptr);
    ASSERT_TRUE(loadPlugin(nullptr));
}

}  // namespace

void GoldenTypekit::SetUp() {
    const fs::path dir = test::goldenDir("typekit", GetParam());
    const fs::path before = fs::current_path();
    fs::current_path(dir);
    diag::Sink sink;
    const auto options = typekit::parseOptions(wordsOf(dir), sink);
    ASSERT_TRUE(options);
    name = options->name;
    cxx::ParseRequest request;
    request.flags = options->flags;
    request.adapters = adapters::readAdapters(options->adapters, sink);
    request.headers = typekit::findHeaders(options->inputs, options->flags, options->name, sink);
    auto read = cxx::readTypes(request, sink);
    fs::current_path(before);
    ASSERT_TRUE(read);
    model = *read;
    typekit::closeModel(model, sink);
    load(RTT_TYPEKIT_FILE);  // the types of numbers and strings
    load(std::string(GOLDEN_TYPEKIT_DIR) + "/libgolden_typekit_" + GetParam() + ".so");
}

const RTT::types::TypeInfo& GoldenTypekit::typeOf(const std::string& name) {
    const RTT::types::TypeInfo* type = RTT::types::Types()->type(name);
    if (type == nullptr) throw std::out_of_range("no type " + name);
    return *type;
}

}  // namespace oroforge::test
