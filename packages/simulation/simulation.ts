import { placeByHand, settle } from './place.ts'
import { createScene, takeUpState } from './scene.ts'
import { noteHeadings, noteMotion } from './sensors/motion.ts'
import { createReadings, forgetReadings, raysOf, read, sendReadings } from './sensors/readings.ts'
import { copyState } from './state.ts'
import { stepScene } from './step.ts'
import type { Floor, Simulation, World } from './types.ts'

/** Sets a world in motion. Things and robots that overlap at the start are put at the nearest free place. */
export function createSimulation(world: World, floor: Floor, seed: number): Simulation {
  const scene = createScene(world, seed)
  settle(scene)
  const readings = createReadings(scene, floor)
  const headings = new Float64Array(world.robots.length)
  return {
    world,
    state: scene.state,
    step: () => {
      sendReadings(readings)
      noteHeadings(scene, headings)
      stepScene(scene)
      noteMotion(scene, headings)
      readings.moment++
    },
    read: (robot, port, mode) => read(readings, robot, port, mode),
    rays: (robot, port) => raysOf(readings, robot, port),
    place: (id, pose) => {
      readings.moment++
      forgetReadings(scene)
      return placeByHand(scene, id, pose)
    },
    settle: () => {
      readings.moment++
      settle(scene)
    },
    keyframe: () => copyState(scene.state),
    restore: (state) => {
      readings.moment++
      Object.assign(scene.state, copyState(state))
      takeUpState(scene)
    },
  }
}
