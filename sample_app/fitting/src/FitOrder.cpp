#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/fitting/FitOrder.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/peers/Peer.h>

#include <utility>

namespace fbrdf::fitting {
namespace {

LobeFitOptions lobesOf(const FitOrder& order)
{
    order.fit.watch.say("fitting lobes");
    LobeFitOptions lobes = lobeOptions(order.lobes);
    lobes.threads = order.fit.threads;
    return lobes;
}

void setMaterial(const FitOrder& order, Material material, FitReply& reply)
{
    if (order.lobes > 0) material.lobes = fitLobes(material, lobesOf(order));
    reply.note = describe(material.form);
    reply.material = std::make_shared<const Material>(std::move(material));
}

void setFunction(const FitOrder& order, const BrdfFunction& brdf, FitReply& reply)
{
    reply.brdf = brdf;
    if (order.lobes > 0) reply.lobes = fitLobes(brdf, reply.source->isotropic, lobesOf(order));
}

void fitForm(const FitOrder& order, FitReply& reply)
{
    FitResult result = fitMaterial(*reply.source, order.fit);
    reply.summary = std::move(result.summary);
    setMaterial(order, std::move(result.material), reply);
}

void openFunction(const FitOrder& order, FitReply& reply)
{
    if (std::optional<Material> material = readIfMaterial(order.source)) {
        setMaterial(order, std::move(*material), reply);
    } else {
        setFunction(order, reply.source->evaluate, reply);
        reply.note = reply.source->description;
    }
}

void fitPeer(const FitOrder& order, FitReply& reply)
{
    const Peer& peer = findPeer(order.peer);
    const std::optional<PeerFit> fit = peer.fit(
        *reply.source, {publishedDataDir(), order.fit.threads, order.fit.seed, order.fit.watch});
    if (!fit)
        throw Error(ErrorKind::usage, peer.name,
                    Found("nothing for '" + reply.source->name + "'").expected(peer.needs));
    if (fit->material)
        setMaterial(order, *fit->material, reply);
    else
        setFunction(order, fit->brdf, reply);
    reply.note = fit->note;
}

}  // namespace

FitReply fitted(const FitOrder& order, std::shared_ptr<const Source> source)
{
    FitReply reply;
    reply.source = std::move(source);
    if (!order.peer.empty())
        fitPeer(order, reply);
    else if (order.functionIsEnough && reply.source->evaluate)
        openFunction(order, reply);
    else
        fitForm(order, reply);
    return reply;
}

}  // namespace fbrdf::fitting
