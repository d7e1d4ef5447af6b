// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "../door/module.hpp"

#include "server.hpp"

#include <exception>

#include <unistd.h>

OCL::live::RunningServer* oroLiveServe(const OCL::live::ServerStart& start, std::string& error) noexcept {
    try {
        auto server = std::make_unique<OCL::live::Server>(start);
        if (server->begin()) return server.release();
        error = "there is no thread for it";
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    return nullptr;
}
