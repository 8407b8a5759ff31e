#include "wellspaced/kernel/predicates.hpp"
