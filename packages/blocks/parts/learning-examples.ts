import type { Template } from '../types.ts'
import { forever, number, start } from './examples.ts'

export const barrier = (from: number, to: number): Template => ({
  type: 'ai_q_barrier_mountain',
  fields: { FROM: String(from), TO: String(to) },
})

export const obstacles = (roads: readonly (readonly [number, number])[]): Template => ({
  type: 'rl_obstacles_easy_list',
  mutation: { attrs: { items: String(roads.length), list_type: 'Obstacle' } },
  ...(roads.length > 0 && {
    values: Object.fromEntries(roads.map(([from, to], k) => [`ADD${k}`, barrier(from, to)])),
  }),
})

/** The map of the first card. */
export const learningMap = (closed: Template = obstacles([])): Template => ({
  type: 'ai_q_learning_states_and_actions_map',
  fields: { MAP: 'MAP_RAILWAY', START: '3', FINISH: '1' },
  values: { OBSTACLE: closed },
})

export const learner: Template = {
  type: 'ai_q_learner_config',
  fields: {
    ...{ ALPHA: '0.5', GAMMA: '0.8', NU: '0.1', RHO: '0.5' },
    ...{ ALPHA_DECAY: '', RHO_DECAY: '', RULES: 'standard' },
  },
}

export const gainExperience: Template = {
  type: 'ai_q_apply_learning_rule',
  fields: { EPISODES: '100', Q_LEARNER_TIME: '10000' },
}

const colourSensor = (mode: 'COLOUR' | 'LIGHT'): Template => ({
  type: 'robSensors_colour_getSample',
  fields: { MODE: mode, SENSORPORT: '1', SLOT: '' },
  mutation: { attrs: { mode } },
})

const motor = (port: string, power: number): Template => ({
  type: 'robActions_motor_on',
  fields: { MOTORPORT: port },
  values: { POWER: number(power) },
})

const decide = (
  condition: Template,
  then: readonly Template[],
  otherwise: readonly Template[],
): Template => ({
  type: 'robControls_ifElse',
  mutation: { attrs: { else: '1' } },
  values: { IF0: condition },
  statements: { DO0: then, ELSE: otherwise },
})

const onRed: Template = {
  type: 'logic_compare',
  fields: { OP: 'EQ' },
  values: { A: colourSensor('COLOUR'), B: { type: 'robColour_picker', fields: { COLOUR: '#B30006' } } },
}

const onWhite: Template = {
  type: 'logic_compare',
  fields: { OP: 'GT' },
  values: { A: colourSensor('LIGHT'), B: number(50) },
}

/**
 * Follows the edge between white (left) and black (right): on white to the right, on black to the left, one wheel at a
 * time. Stands still on red. Measured on every way of every map: benchmarks/results/q-driving.md.
 */
export const follower: Template = {
  type: 'ai_q_drive_the_best_way',
  statements: {
    DO: [
      forever(
        decide(
          onRed,
          [{ type: 'robActions_motorDiff_stop' }],
          [decide(onWhite, [motor('C', 30), motor('B', 0)], [motor('C', 0), motor('B', 30)])],
        ),
      ),
    ],
  },
}

export const drawWay: Template = { type: 'ai_q_draw_the_best_way' }

/** Start, learn on a map, draw the way and drive it. */
export const learningProgram = (closed?: Template): readonly Template[] => [
  ...[start, learningMap(closed), learner, gainExperience, drawWay, follower],
]
