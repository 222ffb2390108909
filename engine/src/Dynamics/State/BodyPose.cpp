// SPDX-License-Identifier: MIT
#include "BodyPose.h"

#include "Reach.h"

namespace box2d
{

void SynchronizePose(BodyData& body)
{
    body.pose =
        Pose{WithinReach(body.pose.x), WithinReach(body.pose.y), WithinReach(body.pose.angle)};
    const auto [sine, cosine] = SinCos(body.pose.angle);
    body.rotation.s = float32(sine);
    body.rotation.c = float32(cosine);
    const double lx = body.localCenter.x;
    const double ly = body.localCenter.y;
    body.transform.q = body.rotation;
    body.transform.p = b2Vec2(float32(body.pose.x - (cosine * lx - sine * ly)),
                              float32(body.pose.y - (sine * lx + cosine * ly)));
    body.worldCenter = b2Vec2(float32(body.pose.x), float32(body.pose.y));
    body.room = 0.0f;
}

void SynchronizePlace(BodyData& body)
{
    if (body.localCenter != b2Vec2(0.0f, 0.0f))
    {
        SynchronizePose(body); // with sine and cosine in double precision
        return;
    }
    body.pose.x = WithinReach(body.pose.x);
    body.pose.y = WithinReach(body.pose.y);
    body.worldCenter = b2Vec2(float32(body.pose.x), float32(body.pose.y));
    body.transform.q = body.rotation;
    body.transform.p = body.worldCenter;
}

} // namespace box2d
