// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "golden_typekit.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <iterator>
#include <sstream>

#include <adapters/read_adapters.hpp>
#include <clang/types/type_reader.hpp>
#include <collect/close_model.hpp>
#include <collect/header_inputs.hpp>
#include <driver/options.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <support/run_typegen.hpp>

namespace fs = std::filesystem;

namespace oroforge::test {

namespace {

void load(const std::string& file) {
    void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << ::dlerror();
    const auto loadPlugin = reinterpret_cast<bool (*)(RTT::TaskContext*)>(::dlsym(library, "loadRTTPlugin"));
    ASSERT_NE(loadPlugin, nullptr);
    ASSERT_TRUE(loadPlugin(nullptr));
}

}  // namespace

std::vector<std::string> builtTypekits() {
    std::istringstream words(GOLDEN_TYPEKITS);
    return {std::istream_iterator<std::string>(words), {}};
}

void GoldenTypekit::SetUp() {
    fs::path dir = test::goldenDir("typekit", GetParam());
    if (!fs::exists(dir)) dir = test::goldenDir("typekit_view", GetParam());
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
