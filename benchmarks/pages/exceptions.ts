import type { Finding } from './findings.ts'

/** A finding that is meant to be so. */
export interface Exception {
  /** Ids of items; all where none is named. */
  readonly items?: readonly string[]
  readonly kind: Finding['kind']
  readonly what: RegExp
  readonly because: string
}

export const exceptions: readonly Exception[] = [
  {
    items: ['further-material'],
    kind: 'language',
    what: /“(Machine Learning for Kids|Elements of AI|UNESCO: AI competency|University of Helsinki)/,
    because: 'names of courses, a framework and a university, as their makers write them',
  },
]

/** The exception that a finding falls under. */
export const exceptionFor = (
  item: string,
  { kind, what }: Finding,
  known = exceptions,
): Exception | undefined =>
  known.find((one) => one.kind === kind && (one.items?.includes(item) ?? true) && one.what.test(what))
