#include "my-pkg-component.hpp"

#include <iostream>

#include <rtt/Component.hpp>

My_pkg::My_pkg(const std::string& name) : RTT::TaskContext(name) {
    std::cout << "My_pkg constructed\n";
}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
My_pkg::~My_pkg() { this->stopForGood(); }

bool My_pkg::configureHook() {
    std::cout << "My_pkg configured\n";
    return true;
}

bool My_pkg::startHook() {
    std::cout << "My_pkg started\n";
    return true;
}

void My_pkg::updateHook() {
    std::cout << "My_pkg executes updateHook\n";
}

void My_pkg::stopHook() {
    std::cout << "My_pkg stopping\n";
}

void My_pkg::cleanupHook() {
    std::cout << "My_pkg cleaning up\n";
}

// Makes the class known to the loader under its own name. A library with several components uses
// ORO_CREATE_COMPONENT_LIBRARY() once and ORO_LIST_COMPONENT_TYPE(Class) for each.
ORO_CREATE_COMPONENT(My_pkg)
