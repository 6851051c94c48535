import { content } from '@botgarten/content/files'
import {
  csvOf,
  finish,
  laneKinds,
  race,
  summariesOf,
  type Lane,
  type LaneKind,
  type LaneResult,
  type Summary,
} from '@botgarten/experiments/brain-race'
import type { Command } from './commands.ts'
import { CallError } from './errors.ts'
import { write } from './files.ts'
import { seedOf } from './learn-options.ts'
import { options, refuseMore } from './options.ts'
import { readProjectFile } from './project-file.ts'
import { message } from './words.ts'

const known = {
  course: { type: 'string' },
  hand: { type: 'string' },
  examples: { type: 'string' },
  trying: { type: 'string' },
  'if-then': { type: 'string' },
  seed: { type: 'string' },
  csv: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

/** `botgarten race four-brains …`: four brains on one course, and what each has cost. */
export const fourBrains: Command = { options: known, execute: raceOnce }

function raceOnce(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const course = courseNamed(values.course ?? 'garden')
  const { id, shown, seconds, measure } = course
  const seed = seedOf(values)
  const world = content.world(course.world)!
  const lanes = laneKinds.map((kind) => laneOf(id, kind, values))
  const results = finish(race({ course, world, floor: content.floorOf(world) }, lanes, seed))
  if (values.csv !== undefined) write(values.csv, csvOf(course, results))
  const summaries = summariesOf(results, lanes)
  if (!values.json) return summaries.map((summary, at) => sentenceOf(results[at]!, summary)).join('\n')
  const reports = results.map((result, at) => reportOf(result, summaries[at]!, shown))
  return JSON.stringify({ course: id, seed, seconds, measure: measure.kind, lanes: reports })
}

function courseNamed(name: string) {
  const course = content.courses.find(({ id }) => id === name)
  const names = content.courses.map(({ id }) => id).join(', ')
  if (!course) throw new CallError('call.noCourse', { name, names })
  return course
}

const optionOf = (kind: LaneKind) => (kind === 'ifThen' ? 'if-then' : kind)

/** A project of the call, else the course's own brain. */
function laneOf(course: string, kind: LaneKind, values: Values): Lane {
  const path = values[optionOf(kind)]
  return { kind, racer: path === undefined ? content.racer(course, kind) : readProjectFile(path) }
}

function reportOf({ kind, problem, runs }: LaneResult, summary: Summary | null, shown: number) {
  const starts = (runs ?? []).map(({ trail: _, from: _from, ...run }, at) => ({
    ...run,
    sealed: at >= shown,
  }))
  if (!summary) return { kind, problem, starts }
  const { score, cm, atWall, bumps, decisions, bill } = summary
  return { kind, problem, score, cm, atWall, bumps, decisions, bill, starts }
}

function sentenceOf({ kind, problem }: LaneResult, summary: Summary | null): string {
  const lane = message(`brainRace.${kind}`)
  if (!summary) return message(`brainRace.${problem ?? 'missing'}`, { lane })
  const { cm, bumps, decisions, bill } = summary
  return message('brainRace.drove', { lane, cm: Math.round(cm), bumps, decisions, parts: bill.parts })
}
