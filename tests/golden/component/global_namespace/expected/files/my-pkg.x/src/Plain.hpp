#ifndef MY_PKG_X_PLAIN_HPP
#define MY_PKG_X_PLAIN_HPP

#include <my-pkg.x/PlainBase.hpp>

/// Ports, properties and attributes are members of the base class: PlainBase, generated from my-pkg.x.xml.
class Plain : public PlainBase {
public:
    explicit Plain(const std::string& name);
    ~Plain() override;

    void go() override;

    int pick(const std::string& first, double second) override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

#endif
