import { m } from '#words/message.ts'

/** Colours of bodies and trails, by the robot's place among all. */
export const bodies = ['#F28C45', '#5AA9DE', '#8CC63F', '#B98AE0'] as const

/** What a child calls a robot, by its place among all (from 0). */
export const robotName = (index: number): string =>
  index === 0 ? m['world.robot']() : m['robots.name']({ number: index + 1 })
