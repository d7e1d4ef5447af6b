#include <tank/PlantBase.hpp>

#define OPERATION(name) void name() override

namespace tank {

class Plant : public PlantBase {
public:
    explicit Plant(const std::string& name);
    void changed(bool a) override;
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
};

}  // namespace tank
