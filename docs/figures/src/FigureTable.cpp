// SPDX-License-Identifier: MIT
#include "FigureTable.h"

#include "Drawings.h"

namespace figures
{

const std::vector<FigureEntry>& FigureTable()
{
    static const std::vector<FigureEntry> table{
        {"modules", "Three boxes: Dynamics uses Collision and Common, Collision uses Common",
         "The three modules: each builds on those to its left, and on nothing else.", DrawModules},
        {"falling-box", "A box before it falls, and where it lies after sixty steps",
         "The first program: the box lands after 46 steps, and rests on the skins.",
         DrawFallingBox},
        {"convex-and-concave",
         "A convex polygon with a line between two of its points, a concave one that such a line "
         "leaves",
         "A polygon is convex when no line between two points of it ever leaves it; only such "
         "polygons are shapes.",
         DrawConvexAndConcave},
        {"winding", "The same polygon, its vertices numbered counter-clockwise and clockwise",
         "Vertices are kept counter-clockwise, in a frame with x to the right and y up.",
         DrawWinding},
        {"polygon-skin",
         "A polygon of a few centimetres, and its outline one centimetre further out",
         "Around each polygon lies a skin as thick as its radius; what is drawn is the polygon "
         "within.",
         DrawPolygonSkin},
        {"skin-gap",
         "A box of a few centimetres that lies on another, a gap between them, where their skins "
         "overlap a little",
         "Skins rest on each other, so between the polygons a gap stays open; from it impacts can "
         "be told in time.",
         DrawSkinGap},
        {"ghost-collision",
         "A box that slides along two edges is thrown back where they meet, by a normal along the "
         "ground",
         "The second edge is looked at as if it stood alone, so its end pushes the box back where "
         "the ground is level.",
         DrawGhostCollision},
        {"ghost-vertices",
         "An edge from m_vertex1 to m_vertex2 that knows m_vertex0 and m_vertex3; the box slides "
         "on",
         "An edge that knows its neighbours' far ends lets the same box slide over.",
         DrawGhostVertices},
        {"chain", "A ball rolls along a chain of five edges",
         "A chain knows all its neighbours, and with a previous and a next vertex also those of "
         "the chains beside it.",
         DrawChain},
        {"self-intersection", "A chain whose fourth edge crosses its second",
         "A chain must not cross itself: at the crossing no edge knows of the other.",
         DrawSelfIntersection},
        {"manifolds", "Three pairs of shapes that overlap, with their contact points and normals",
         "A manifold has one normal, from A to B, and one point or two.", DrawManifolds},
        {"distance", "The shortest line between two polygons",
         "What b2Distance finds: the nearest points of two shapes, and how far apart they are.",
         DrawDistance},
        {"tunnelling", "A fast ball is before a wall in one step and behind it in the next",
         "Without continuous collision a ball that goes a metre a step is never seen to touch a "
         "thin wall.",
         DrawTunnelling},
        {"continuous-collision", "The same ball stops at the wall",
         "With it the ball is stopped at the time of its impact.", DrawContinuousCollision},
        {"impact-within-step",
         "A ball flies down, touches the floor within a step, and is on its way up at the end of "
         "the same step",
         "Continuous collision: the ball goes along its sweep to the time of impact, bounces, and "
         "takes the rest of the step as a sub-step.",
         DrawImpactWithinStep},
        {"time-of-impact",
         "A box on its way through a wall, at the start, at the impact, at the end",
         "b2TimeOfImpact tells which part of the way is free, from 0, the start, to 1, the end.",
         DrawTimeOfImpact},
        {"time-of-impact-turning",
         "A rod that turns past a post: free at the start and at the end, touching in between",
         "A rod that turns is free at both ends of its step; that it meets the post in between is "
         "found here, where the manual lets it be missed.",
         DrawTimeOfImpactTurning},
        {"time-of-impact-missed",
         "The rod before the post in one step and past it in the next: it has gone through",
         "Such an impact missed: a world that looks at its bodies step by step only, "
         "SetContinuousPhysics(false). With continuous collision this engine misses none, so this "
         "is the only way to see it.",
         DrawMissedImpact},
        {"dynamic-tree",
         "Eight shapes in nested boxes, the tree of these boxes, and a ray that meets two of the "
         "shapes' boxes",
         "A ray goes down the tree only where it meets a box; below a box that it misses nothing "
         "is tested.",
         DrawDynamicTree},
        {"ray-cast", "A ray among seven shapes hits three of them; the nearest hit is marked",
         "A ray cast reports where shapes are hit, the normal there, and which fraction of the "
         "ray lies before.",
         DrawRayCast},
        {"region-query",
         "Seven shapes with their boxes, and a region that overlaps two shapes and two more boxes",
         "A region query reports the fixtures whose boxes overlap the region: here two shapes that "
         "overlap it, and a rod and a triangle of which only the boxes do.",
         DrawRegionQuery},
        {"body-origin",
         "A body shaped like an L: its origin is its outer corner, its centre of mass lies between "
         "the arms",
         "A body's position is its origin, to which shapes and joints are attached; it moves and "
         "turns about its centre of mass.",
         DrawBodyOrigin},
        {"slope", "Three boxes of friction 0.0, 0.1 and 0.3 on a slope; two slide, the third stays",
         "On a surface of friction 1, whose square root of the product with theirs has to be above "
         "the tangent of the slope, 0.47, only the third stays.",
         DrawSlope},
        {"bounces", "Three balls that bounce to different heights",
         "Restitutions of 0, 0.5 and 1: not at all, to a quarter of the height, to all of it.",
         DrawBounces},
        {"distance-joint", "A load that swings on a rod, and one that bounces on a spring",
         "A distance joint keeps two points as far apart as they were, rigidly or as a spring.",
         DrawDistanceJoint},
        {"revolute-joint", "An arm that turns about an anchor between two limits",
         "A revolute joint lets two bodies turn about a common point; its angle can be limited and "
         "driven.",
         DrawRevoluteJoint},
        {"prismatic-joint", "A cart that slides up an axis between two limits",
         "A prismatic joint lets a body slide along an axis without turning; its translation can "
         "be limited and driven.",
         DrawPrismaticJoint},
        {"pulley-joint", "Two loads on a rope over two wheels; the heavy one goes down",
         "A pulley joint: what one side of the rope loses the other gains, times a ratio.",
         DrawPulleyJoint},
        {"gear-joint", "A wheel that turns and a rack that it moves",
         "A gear joint makes two joints, revolute or prismatic, move in proportion.",
         DrawGearJoint},
        {"mouse-joint", "A box that is pulled towards a target by a point near one of its corners",
         "A mouse joint pulls a point of a body towards a target, as a spring with a greatest "
         "force does.",
         DrawMouseJoint},
        {"wheel-joint", "A car on a bumpy road with two sprung wheels",
         "A wheel joint keeps a wheel's hub on an axis of the car, with a spring along it.",
         DrawWheelJoint},
        {"weld-joint", "Five planks, welded end to end and to a wall, bend under their weight",
         "A weld joint is to allow no motion; in a row welds bend, here softer than they need be.",
         DrawWeldJoint},
        {"rope-joint", "A ball falls freely until its rope is taut, then swings",
         "A rope joint only says how far apart two points may be at most.", DrawRopeJoint},
        {"friction-joint",
         "A box, seen from above, slides and turns ever more slowly until it rests",
         "A friction joint brakes a body against another, as a floor does that is looked at from "
         "above.",
         DrawFrictionJoint},
        {"motor-joint", "A box moves to a place and an angle relative to another box",
         "A motor joint drives a body to an offset and an angle, with as much force as it is "
         "allowed.",
         DrawMotorJoint},
        {"one-way-platform", "A ball flies through a platform from below and lands on it",
         "A contact that a listener switches off while the ball comes from below.",
         DrawOneWayPlatform},
        {"sub-steps",
         "Two stacks of ten boxes with a heavy one on top: one is pressed together, the other "
         "stands as it was built",
         "A thousand kilograms on nine boxes of one kilogram each, after ten seconds. The dashes "
         "show how high the stacks were built.",
         DrawSubSteps},
        {"debug-draw",
         "A small world with shapes, joints, boxes, pairs and centres of mass, and a "
         "legend",
         "What the world draws of itself, by the flags that switch it on.", DrawDebugLayers},
    };
    return table;
}

} // namespace figures
