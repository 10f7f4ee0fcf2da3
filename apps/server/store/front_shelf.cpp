#include "server/store/front_shelf.h"

#include <utility>

#include "server/http/http_error.h"
#include "server/store/kept_front.h"
#include "server/store/new_id.h"

namespace tramline::server {

KeptFrontPtr FrontShelf::add(KeptFront front) {
  front.id = new_id();
  const std::lock_guard lock(mutex_);
  fronts_.push_back(std::make_shared<const KeptFront>(std::move(front)));
  if (fronts_.size() > most_) fronts_.pop_front();
  return fronts_.back();
}

KeptFrontPtr FrontShelf::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  for (const KeptFrontPtr& front : fronts_)
    if (front->id == id) return front;
  throw HttpError(Fault::kNotFound, "this comparison is not kept any more; compare again");
}

}  // namespace tramline::server
