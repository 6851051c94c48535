import { readSetting, writeSetting } from '#storage/settings.ts'

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
