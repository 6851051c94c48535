import { stream } from '@botgarten/numbers'
import { radiansOf } from './angles.ts'
import type { Obstacle, ObstacleState, Pose, RobotState, SimulationState, World } from './types.ts'

/** The state at tick 0, everything where the world has it. */
export function startState(world: World, seed: number): SimulationState {
  return {
    tick: 0,
    robots: world.robots.map(({ pose }) => startRobot(pose)),
    obstacles: world.obstacles.map(startObstacle),
    noise: stream(seed, 'noise'),
  }
}

function startRobot(pose: Pose): RobotState {
  const motor = () => ({ percent: 0, turned: 0, left: null })
  const heading = radiansOf(pose.heading)
  return {
    x: pose.x,
    y: pose.y,
    heading,
    motors: { A: motor(), B: motor(), C: motor(), D: motor() },
    move: null,
    led: null,
    blink: null,
    picture: null,
    display: [],
    tone: null,
    volume: 50,
    language: '',
    speech: null,
    touching: [],
    spin: 0,
    gyroZero: { '1': heading, '2': heading, '3': heading, '4': heading },
    timers: [0, 0, 0, 0, 0],
    keys: [],
    late: null,
  }
}

function startObstacle({ id, pose }: Obstacle): ObstacleState {
  return { id, x: pose.x, y: pose.y, heading: radiansOf(pose.heading), vx: 0, vy: 0, spin: 0 }
}

/** A copy that shares nothing with the state. */
export function copyState({ tick, robots, obstacles, noise }: SimulationState): SimulationState {
  return {
    tick,
    robots: robots.map(copyRobot),
    obstacles: obstacles.map((obstacle) => ({ ...obstacle })),
    noise: [...noise],
  }
}

function copyRobot(robot: RobotState): RobotState {
  const { A, B, C, D } = robot.motors
  return {
    ...robot,
    motors: { A: { ...A }, B: { ...B }, C: { ...C }, D: { ...D } },
    move: robot.move && { ...robot.move },
    display: [...robot.display],
    tone: robot.tone && { ...robot.tone },
    speech: robot.speech && { ...robot.speech },
    touching: [...robot.touching],
    gyroZero: { ...robot.gyroZero },
    timers: [...robot.timers],
    keys: [...robot.keys],
    late: robot.late && { turns: [...robot.late.turns], readings: [...robot.late.readings] },
  }
}
