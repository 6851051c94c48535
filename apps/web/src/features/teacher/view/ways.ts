import { resolve } from '$app/paths'

/** What is shown of a class. */
const views = ['live', 'cards', 'gallery', 'questionnaires', 'class', 'data'] as const
export type View = (typeof views)[number]

export const isView = (name: string | null): name is View => views.some((view) => view === name)

/** Address of a class; without a view its first. */
export const toClass = (id: string, view: View = 'live') =>
  resolve(`/teacher?class=${encodeURIComponent(id)}&view=${view}`)

export const toProjector = (id: string) => resolve(`/teacher/projector?class=${encodeURIComponent(id)}`)

/** The race of four brains with those that the class has shared. */
export const toBrainRace = (id: string) => resolve(`/race?brains=garden&class=${encodeURIComponent(id)}`)
