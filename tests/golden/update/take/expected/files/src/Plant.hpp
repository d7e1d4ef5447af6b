#include <tank/PlantBase.hpp>

#define OPERATION(name) void name() override

namespace tank {

class Plant : public PlantBase {
public:
    explicit Plant(const std::string& name);
    void changed(double a) override;
    void mine(float a) override;
    int unknown(int);
    OPERATION(made);
    void commented(int a /* what users typed */) override;
#ifdef SIMULATION
    void branch(bool simulated);
    void skipped() override;
#else
    void branch() override;
#endif

protected:
    void updateHook() override {
        // One step: read inputs, compute, write outputs. Runs in the component's thread; keep it free of blocking calls.
    }
};

}  // namespace tank
