import { m } from '#words/message.ts'

/** `shared`: the same program, weights of its own · `own`: a program of its own, with weights of its own. */
export type NewRobot = 'shared' | 'own'

/** Colours of bodies and trails, by the robot's place in the crew. */
export const bodies = ['#F28C45', '#5AA9DE', '#8CC63F', '#B98AE0'] as const

/** What a child calls a robot, by its place in the crew (from 0). */
export const robotName = (index: number): string =>
  index === 0 ? m['world.robot']() : m['robots.name']({ number: index + 1 })
