import { m } from '#words/say.ts'

/** What a child calls a robot, by its place in the crew (from 0). */
export const robotName = (index: number): string =>
  index === 0 ? m['world.robot']() : m['robots.name']({ number: index + 1 })
