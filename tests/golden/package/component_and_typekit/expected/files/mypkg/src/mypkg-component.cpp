#include "mypkg-component.hpp"

#include <iostream>

#include <rtt/Component.hpp>

Mypkg::Mypkg(const std::string& name) : RTT::TaskContext(name) {
    std::cout << "Mypkg constructed\n";
}

// From here on no other thread executes hooks or operations of an object that is half destroyed.
Mypkg::~Mypkg() { this->stopForGood(); }

bool Mypkg::configureHook() {
    std::cout << "Mypkg configured\n";
    return true;
}

bool Mypkg::startHook() {
    std::cout << "Mypkg started\n";
    return true;
}

void Mypkg::updateHook() {
    std::cout << "Mypkg executes updateHook\n";
}

void Mypkg::stopHook() {
    std::cout << "Mypkg stopping\n";
}

void Mypkg::cleanupHook() {
    std::cout << "Mypkg cleaning up\n";
}

// Makes the class known to the loader under its own name. A library with several components uses
// ORO_CREATE_COMPONENT_LIBRARY() once and ORO_LIST_COMPONENT_TYPE(Class) for each.
ORO_CREATE_COMPONENT(Mypkg)
