// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The live window of a program: what --no-live and --web ask for.
#ifndef OROFORGE_DEPLOYER_LIVE_WINDOW_HPP
#define OROFORGE_DEPLOYER_LIVE_WINDOW_HPP

#include "deployer_options.hpp"

#include <ocl/DeploymentComponent.hpp>

#include <memory>

namespace OCL::deploy {

/** Lets other programs look at a deployment. Costs a thread that sleeps until the first one comes. */
class LiveWindow {
public:
    /** Listens at what the options name, and reports what is wrong with that. A deployment needs no live window, but
        --web is an error if it cannot be: then failed() is true. */
    explicit LiveWindow(const Options& options);
    ~LiveWindow();
    LiveWindow(const LiveWindow&) = delete;
    LiveWindow& operator=(const LiveWindow&) = delete;

    bool failed() const;

    /** Clients are served while it exists. Ends before the deployer. */
    class Opened {
    public:
        Opened(LiveWindow& window, DeploymentComponent& deployer) : window_(window), good_(window.open(deployer)) {}
        /** Takes leave of all clients. */
        ~Opened() { window_.close(); }
        Opened(const Opened&) = delete;
        Opened& operator=(const Opened&) = delete;
        /** False, with an error reported, if the server that --web asks for does not start. */
        explicit operator bool() const { return good_; }

    private:
        LiveWindow& window_;
        const bool good_;
    };

private:
    bool open(DeploymentComponent& deployer);
    void close();

    struct Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL::deploy

#endif
