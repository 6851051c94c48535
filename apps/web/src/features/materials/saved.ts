import type { LoadedCard } from '#content/cards.ts'
import { load, open, save } from '#storage/projects.ts'
import { cardProject } from '@botgarten/content/document'
import type { Progress } from '@botgarten/programs'
import { titleOf } from '#content/names.ts'
import { message } from '#words/message.ts'
import { programOf } from './programs.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'

const none: Progress = { starts: [], hints: 0 }

/** How far this device has come with a card in the lab: from where it was solved, and how many hints were asked for. */
export const progressOf = async (card: string): Promise<Progress> =>
  (await open(card))?.project.progress ?? none

/**
 * Notes that so many hints of a card are seen: in the project that the lab opens for it. Where the device keeps nothing, or
 * another tab saves at this very moment, the hint is seen all the same.
 */
export async function noteHint({ card, world, start }: LoadedCard, shown: number): Promise<Progress> {
  const kept = await open(card.id)
  // What is damaged stays as it is.
  if (!kept && (await load(card.id))) return { starts: [], hints: shown }
  const project = kept?.project ?? cardProject(world, card, start, card.id)
  const before = project.progress ?? none
  const progress = { ...before, hints: Math.max(before.hints, shown) }
  await save(card.id, { ...project, progress }, kept?.revision ?? 0)
  return progress
}

/** A project laid out, by its key. `asStart`: the device keeps nothing, so the lab opens the card with its start program. */
interface LaidOut {
  readonly id: string
  readonly asStart: boolean
}

/**
 * Lays a card out for a class, with the program that the slide names, whatever was done with it the last time. One project
 * for each such slide is kept: what children keep of the card stays theirs.
 */
export async function layOut(card: string, file: string): Promise<LaidOut> {
  const id = `slide-${card}-${file}`
  const kept = await load(id)
  if (!kept && file === 'start') return { id, asStart: false }
  const { card: loaded, program } = await programOf(card, file)
  const name = `${titleOf(card)} · ${message('materials.onSlides')}`
  const project = cardProject(loaded.world, loaded.card, program, name)
  const { kind } = await save(id, project, kept?.revision ?? 0)
  // Another window that shows the same slide has laid out the same.
  return { id, asStart: file !== 'start' && kind !== 'saved' && kind !== 'newer' }
}

/** Before a module, and after it. */
export const phases = ['before', 'after'] as const
export type Phase = (typeof phases)[number]

/** What was answered, by question. */
export type Answers = { readonly [question: string]: string | undefined }

const nameOf = (module: number, phase: Phase) => `questions-${module}-${phase}`

const isAnswers = (kept: unknown): kept is Answers =>
  typeof kept === 'object' && kept !== null && Object.values(kept).every((one) => typeof one === 'string')

/** What was answered on this device; nothing where it keeps nothing, or something else. */
export function readAnswers(module: number, phase: Phase): Answers {
  const kept = readSetting<unknown>(nameOf(module, phase), {})
  return isAnswers(kept) ? kept : {}
}

export const keepAnswers = (module: number, phase: Phase, answers: Answers): void =>
  writeSetting(nameOf(module, phase), answers)
