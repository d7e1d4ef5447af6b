#ifndef OROCOS_MYPKG_COMPONENT_HPP
#define OROCOS_MYPKG_COMPONENT_HPP

#include <string>

#include <rtt/RTT.hpp>

class Mypkg : public RTT::TaskContext {
public:
    explicit Mypkg(const std::string& name);
    ~Mypkg() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

#endif
