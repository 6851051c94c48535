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
  {
    items: ['meet-bo'],
    kind: 'overlap',
    what: /^“div” and “Bo /,
    because: 'Bo stands on the frame of the picture below; its drawing has an empty edge',
  },
  {
    items: ['meet-bo'],
    kind: 'cut',
    what: /^“div”$/,
    because: 'only the empty edge of Bo’s drawing leaves the box; Bo is whole',
  },
  {
    items: ['q-flow'],
    kind: 'overlap',
    what: /^“svg” and “div”$/,
    because: 'Bo stands in a free corner of the diagram',
  },
]

/** The exception that a finding falls under. */
export const exceptionFor = (
  item: string,
  { kind, what }: Finding,
  known = exceptions,
): Exception | undefined =>
  known.find((one) => one.kind === kind && (one.items?.includes(item) ?? true) && one.what.test(what))
