#pragma once
#include <tank/PlantBase.hpp>

namespace tank { namespace models {

class Plant : public PlantBase
{
  public:
    explicit Plant( const std::string& name );

    /** Fills it. */
    virtual int fill( double amount = 1.0 /* litres */ );   ///< mine
                                                            ///< and this
    virtual void old() { }
    int fill( int ) { return 0; } // an overload

    virtual void drain( double amount,
                        bool slowly );

  protected:
#ifdef TRACE
    virtual void trace();
#endif
    virtual void updateHook();
};

} }
