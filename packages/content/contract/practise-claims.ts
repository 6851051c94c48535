import { brainsFor } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Examples } from '@botgarten/learning/neural-network/examples'
import { percentOff, type CurvePoint } from '@botgarten/learning/neural-network/train'
import { networks } from '@botgarten/programs'
import { withHidden, type Hidden } from '@botgarten/programs/examples'
import { content } from '../files.ts'
import type { CardProgram } from '../index.ts'
import type { PractiseClaim } from '../schema/planTypes.ts'
import { practised } from './practised.ts'
import { solved } from './solved.ts'

/** What practice comes to, of all that the claim names. */
export function practisedBy(claim: PractiseClaim): Partial<PractiseClaim> {
  const { practises, off, weights, lowest, misses, of } = claim
  const program = programOf(claim)
  const [begun] = Object.values(program.brains)
  const after = (seed: number) => practised(practises, program, seed)
  const own = off || weights ? after(begun!.practice!.seed) : null
  return {
    ...(off && { off: offIn(own!.curve, off) }),
    ...(weights && { weights: roundedIn(own!.brain, weights) }),
    ...(misses && { misses: missedBy(claim, program, begun!.practice!.seed) }),
    ...(lowest && { lowest: lowest.map((_, at) => lowestIn(after(at + 1).curve)) }),
    ...(of !== undefined && {
      found: seedsTo(of).filter((seed) => missedBy(claim, program, seed).length === 0).length,
    }),
  }
}

const seedsTo = (last: number) => Array.from({ length: last }, (_, at) => at + 1)

/** Checks of the card that Bo misses from any of its places. */
function missedBy({ practises: id }: PractiseClaim, program: CardProgram, seed: number): readonly string[] {
  const { brain } = practised(id, program, seed)
  const brains = Object.fromEntries(Object.keys(program.brains).map((key) => [key, brain]))
  const { card, failures } = solved(id, () => ({ ...program, brains }))
  const missed = card.starts.flatMap((_, place) => failures(place, 1, {}))
  return card.checks.flatMap((check) => (missed.includes(check.id) ? [check.id] : []))
}

/** The card's program with other hidden layers, rows and settings. */
function programOf({ practises: id, file = 'solution', hidden, ...claim }: PractiseClaim): CardProgram {
  const given = content.program(id, file)!
  const network = Object.values(given.programs).flatMap(networks)[0]!
  const programs = hidden
    ? mapped(given.programs, (one) => withHidden(one, network.id, hidden as readonly Hidden[]))
    : given.programs
  const brains = hidden ? brainsFor(programs, given.brains) : given.brains
  return { ...given, programs, brains: mapped(brains, (brain) => asked(brain, claim)) }
}

function asked(brain: Brain, { settings = {}, wishes, aside }: Partial<PractiseClaim>): Brain {
  const { next, ...practice } = brain.practice!
  const { seed, settings: before } = next ?? practice
  return {
    ...brain,
    examples: rowsAs(brain.examples!, wishes, aside),
    practice: { ...practice, seed, settings: { ...before, ...settings } },
  }
}

/** Where a row says whether it is practised. */
const switchAt = 5

function rowsAs(
  examples: Examples,
  wishes: PractiseClaim['wishes'] = {},
  aside: PractiseClaim['aside'],
): Examples {
  const rows = examples.rows.map((row, at) => {
    const wish = wishes[at + 1]
    const kept = wish ? [...row.slice(0, -wish.length), ...wish] : row
    return aside ? kept.with(switchAt, aside.includes(at + 1) ? 0 : 1) : kept
  })
  return { ...examples, rows }
}

const percent = (loss: number | null) => Math.round(percentOff(loss!))

const offIn = (curve: readonly CurvePoint[], asked: NonNullable<PractiseClaim['off']>) =>
  Object.fromEntries(
    Object.entries(asked).map(([round, names]) => {
      const point = curve.find((one) => one.round === Number(round))!
      const found = {
        practised: percent(point.practised),
        test: point.kept === null ? null : percent(point.kept),
      }
      return [round, Object.fromEntries(Object.keys(names).map((name) => [name, found[name as 'test']]))]
    }),
  )

const roundedIn = (brain: Brain, asked: NonNullable<PractiseClaim['weights']>) =>
  mapped(asked, (row, from) =>
    mapped(row, (_, to) => Math.round(100 * (brain.weights[from]?.[to] ?? 0)) / 100),
  )

const lowestIn = (curve: readonly CurvePoint[]): number =>
  curve.reduce((best, point) => (point.kept! < best.kept! ? point : best)).round

const mapped = <From, To>(
  all: { readonly [name: string]: From },
  change: (one: From, name: string) => To,
): { [name: string]: To } =>
  Object.fromEntries(Object.entries(all).map(([name, one]) => [name, change(one, name)]))
