import { existsSync } from 'node:fs'
import { createLab, type Check, type Document, type Lab } from '@botgarten/lab'
import { cardDocument } from '@botgarten/content'
import type { LoadedCard } from '@botgarten/content/catalogue'
import { content } from '@botgarten/content/files'
import { withLearnedWay } from '@botgarten/maps'
import { mapLookup } from '@botgarten/maps/lookup'
import { check, stationsOf, type Project } from '@botgarten/programs'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { numberIn, options, wholeNumberIn } from './options.ts'
import { isOpenRoberta, readProjectFile } from './project-file.ts'
import { floorOf } from './floor.ts'
import { findMap } from './maps.ts'
import { withWeights } from './weights.ts'
import { message, problemMessage } from './words.ts'

const known = {
  solution: { type: 'boolean' },
  wrong: { type: 'string' },
  weights: { type: 'string' },
  start: { type: 'string' },
  seconds: { type: 'string' },
  seed: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

interface Runnable {
  readonly document: Document & Pick<Project, 'maps'>
  readonly floor: ReturnType<typeof content.floorOf>
  readonly checks: readonly Check[]
  /** Does it drive a way that it learned? */
  readonly drives?: boolean
}

/** `botgarten run FILE|CARD …`: a project or a card without a screen. */
export const run: Command = { options: known, execute: runOnce }

function runOnce(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [what, ...more] = positionals
  if (!what || more.length > 0) throw new CallError('call.runWhat')
  const runnable = learned(withGivenWeights(find(what, values), values))
  const seconds = numberIn('seconds', values.seconds, presetSeconds(runnable), 0, 86_400)
  const seed = wholeNumberIn('seed', values.seed, 1, 0, 4_294_967_295)
  // A foreign program runs as it is, up to what cannot go on.
  if (!isOpenRoberta(what)) refuseWhatCannotRun(runnable.document)
  const lab = createLab()
  lab.load(runnable.document, runnable.floor, { seed, checks: runnable.checks })
  lab.start()
  lab.advance(Math.round(seconds * TICKS_PER_SECOND))
  const report = reportOf(lab, seed)
  return values.json ? JSON.stringify(report) : sentenceOf(report)
}

/** A card's checks say how long it takes; a free project runs a minute, one that learned a way three. */
const presetSeconds = ({ checks, drives }: Runnable) =>
  Math.max(drives ? 180 : 60, ...checks.map(({ seconds }) => seconds))

/** What a program learns by trying it has learned before it drives (seed 1). */
function learned(runnable: Runnable): Runnable {
  const document = withLearnedWay(runnable.document, mapLookup(runnable.document, mapNamed))
  if (document === runnable.document) return runnable
  return { ...runnable, document, floor: content.floorOf(document.world), drives: true }
}

const mapNamed = (id: string) => (content.maps.includes(id) ? findMap(id) : null)

function find(what: string, values: Values): Runnable {
  const found = content.card(what)
  if (found) return cardRun(found, values)
  if (!existsSync(what)) throw new CallError('call.noCardNoFile', { name: what })
  if (values.solution || values.wrong) throw new CallError('call.ofACard')
  return fileRun(what, values)
}

function cardRun({ card, world }: LoadedCard, values: Values): Runnable {
  const start = wholeNumberIn('start', values.start, 0, 0, card.starts.length - 1)
  const program = content.program(card.id, fileFor(card.id, values))!
  const document = cardDocument(world, card, program, start)
  return { document, floor: content.floorOf(document.world), checks: card.checks }
}

function fileFor(card: string, values: Values): string {
  if (values.solution && values.wrong) throw new CallError('call.solutionOrWrong')
  if (values.solution) return 'solution'
  if (values.wrong === undefined) return 'start'
  const names = content.wrongAnswers(card)
  return `wrong/${names[wholeNumberIn('wrong', values.wrong, 1, 1, names.length) - 1]}`
}

function fileRun(path: string, values: Values): Runnable {
  const project = readProjectFile(path)
  const found = project.card === undefined ? null : content.card(project.card)
  if (values.start !== undefined && !found) throw new CallError('call.startOfACard')
  const document = found
    ? values.start === undefined
      ? project
      : cardDocument(
          project.world,
          found.card,
          project,
          wholeNumberIn('start', values.start, 0, 0, found.card.starts.length - 1),
        )
    : project
  return {
    document,
    floor: floorOf(document.world, project.assets),
    checks: found?.card.checks ?? [],
  }
}

function withGivenWeights(runnable: Runnable, { weights }: Values): Runnable {
  if (weights === undefined) return runnable
  return { ...runnable, document: withWeights(runnable.document, weights) }
}

function refuseWhatCannotRun({ programs, world, maps }: Runnable['document']): void {
  const own = stationsOf({ ...(maps && { maps }) })
  for (const robot of world.robots) {
    const program = programs[robot.program]
    const finding = program && check(program, { ...robot.config, maps: own }).find(({ stops }) => stops)
    if (finding)
      throw new FileError('file.cannotRun', {
        why: problemMessage(finding.problem.replace('problem.', ''), finding.facts),
        block: finding.block,
      })
  }
}

function reportOf(lab: Lab, seed: number) {
  const { seconds, robots, checks, problem } = lab.view()
  const [robot] = robots
  if (!robot) throw new FileError('file.noRobot')
  const { pose, trail, led, display, tones } = robot
  const assertions = assertionsOf(lab)
  return { seconds, seed, pose, trail, led, display, tones, checks, assertions, problem, hash: lab.hash() }
}

/** What the program has asserted of itself; of those that failed at most a hundred. */
function assertionsOf(lab: Lab) {
  const { passed = 0, failed = [] } = lab.state().threads[0]?.assertions ?? {}
  return { passed, failed: failed.map(({ id, text, expected, got }) => ({ id, text, expected, got })) }
}

function sentenceOf({ seconds, pose, checks, assertions, hash }: ReturnType<typeof reportOf>): string {
  const [x, y, heading] = [pose.x, pose.y, pose.heading].map((value) => value.toFixed(1))
  const place = message('ran.place', { x: x!, y: y!, heading: heading! })
  const results = checks.map(({ id, passed, at }) => {
    if (!passed) return message('ran.open', { id })
    return at === null ? message('ran.passed', { id }) : message('ran.passedAt', { id, at: at.toFixed(1) })
  })
  const wrong = assertions.failed.map(({ text, expected, got }) =>
    message('ran.asserted', { text, expected, got }),
  )
  const lines = [...results, ...wrong].map((line) => `  ${line}`)
  return [message('ran.end', { seconds, place, hash }), ...lines].join('\n')
}
