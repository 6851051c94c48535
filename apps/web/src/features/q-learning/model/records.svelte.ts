import { groupBy } from '@botgarten/browsers'
import type { Course, Episode } from '@botgarten/learning/q-learning'
import { sectionsOf } from '@botgarten/maps'
import { ownText, type LearnedRun, type LearningOutline, type Pay } from '@botgarten/programs'

const MOST_RUNS = 200
/** Number of runs whose curves are drawn over each other. */
const OVERLAID = 5

/** Rows and curves of earlier runs. */
export class Records {
  #runs = $state.raw<readonly LearnedRun[]>([])
  #curves = $state.raw<readonly (readonly Episode[])[]>([])

  constructor(runs: readonly LearnedRun[]) {
    this.#runs = runs
  }

  /** Rows of the table of experiments, the oldest first. */
  get runs() {
    return this.#runs
  }
  /** Episodes of the last runs, the newest first. */
  get curves() {
    return this.#curves
  }

  note(run: LearnedRun, episodes: readonly Episode[]): void {
    this.#runs = [...this.#runs, run].slice(-MOST_RUNS)
    this.draw(episodes)
  }

  draw(episodes: readonly Episode[]): void {
    this.#curves = [episodes, ...this.#curves.filter((one) => one !== episodes)].slice(0, OVERLAID)
  }

  forget(): void {
    this.#runs = []
  }
}

/** A run as a row of the table of experiments. */
export function rowOf(outline: LearningOutline, course: Course, seed: number, guess: string): LearnedRun {
  const { map, start, goal, closed, settings, pay, episodes: limitEpisodes, moves: limitMoves } = outline
  const { alpha, gamma, nu, rho, rules } = settings
  const { states: stations } = course.way()
  return {
    ...{ map, start, goal, alpha, gamma, nu, rho, rules, limitEpisodes, limitMoves, seed, guess },
    ...(pay && { pay: payText(pay) }),
    closed: closed.map((road) => road.join('-')).join(' '),
    ...{ episodes: course.episodes.length, moves: course.made, way: stations?.join('-') ?? '' },
    ...{ shortest: sectionsOf(course) ?? 0, found: course.foundIn() ?? 0 },
  }
}

/** `length step=1 3:10`: everything that is paid beside the goal. */
const payText = ({ length, step, own = {} }: Pay): string =>
  [length ? 'length' : '', step === undefined ? '' : `step=${step}`, ownText(own)].filter(Boolean).join(' ')

/** The runs of a task, each with its number among all. */
export interface RunsOfTask {
  readonly first: LearnedRun
  readonly rows: readonly { readonly run: LearnedRun; readonly row: number }[]
}

/** Groups runs by task, a table each: runs on another map cannot be compared. */
export function byTask(runs: readonly LearnedRun[]): readonly RunsOfTask[] {
  const rows = runs.map((run, index) => ({ run, row: index + 1 }))
  const tasks = groupBy(rows, ({ run: { map, start, goal, closed } }) =>
    JSON.stringify([map, start, goal, closed]),
  )
  return [...tasks.values()].map((rows) => ({ first: rows[0]!.run, rows }))
}

const columns = [
  ...[
    'map',
    'start',
    'goal',
    'closed',
    'rules',
    'alpha',
    'gamma',
    'nu',
    'rho',
    'limitEpisodes',
    'limitMoves',
  ],
  ...['seed', 'episodes', 'moves', 'way', 'shortest', 'found', 'guess', 'pay'],
] as const satisfies readonly (keyof LearnedRun)[]

/** All runs as CSV (RFC 4180): a head, then a row a run, numbers with a decimal point. */
export function csvOf(runs: readonly LearnedRun[]): string {
  const rows = runs.map((run) => columns.map((column) => cell(run[column] ?? '')))
  return [columns, ...rows].map((row) => row.join(',')).join('\r\n') + '\r\n'
}

/** Cells that begin like this are formulas to a spreadsheet: prefixed, so that opening the table runs nothing. */
const formula = /^[=+@\t]/

function cell(value: string | number): string {
  const text = typeof value === 'string' && formula.test(value) ? `'${value}` : String(value)
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
