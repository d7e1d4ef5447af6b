// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A property file in a folder of its own, and what is said about it.
#ifndef TESTS_UNIT_TYPES_CPF_FIXTURE_HPP
#define TESTS_UNIT_TYPES_CPF_FIXTURE_HPP

#include "builtin_typekit.hpp"
#include "sample_types.hpp"

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>

#include <diag/print.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace types_test {

class Cpf : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
    }
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() / ("cpf_test_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
        file = (folder / "test.cpf").string();
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void putText(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
    void put(const std::string& body) const {
        std::ofstream(file) << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n"
                               "<properties>\n"
                            << body << "\n</properties>\n";
    }
    std::string get() const {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    /** The diagnostics, without the folder. */
    std::string said() const {
        std::string all;
        for (const auto& diagnostic : sink.sorted()) all += oroforge::diag::toString(diagnostic) + "\n";
        for (auto at = all.find(folder.string()); at != std::string::npos; at = all.find(folder.string()))
            all.erase(at, folder.string().size() + 1);
        return all;
    }

    std::filesystem::path folder;
    std::string file;
    oroforge::diag::Sink sink;
    RTT::PropertyBag bag;
};

inline std::string simple(const std::string& type, const std::string& value) {
    return "<simple name=\"p\" type=\"" + type + "\"><value>" + value + "</value></simple>";
}

}  // namespace types_test

#endif
