#ifndef OROCOS_MY_PKG_COMPONENT_HPP
#define OROCOS_MY_PKG_COMPONENT_HPP

#include <string>

#include <rtt/RTT.hpp>

class My_pkg : public RTT::TaskContext {
public:
    explicit My_pkg(const std::string& name);
    ~My_pkg() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

#endif
