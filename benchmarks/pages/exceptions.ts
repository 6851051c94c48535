import type { Finding } from './findings.ts'

/** A finding that is meant to be so. */
export interface Exception {
  /** Ids of items; all where none is named. */
  readonly items?: readonly string[]
  readonly kind: Finding['kind']
  readonly what: RegExp
  readonly because: string
}

export const exceptions: readonly Exception[] = []

/** The exception that a finding falls under. */
export const exceptionFor = (
  item: string,
  { kind, what }: Finding,
  known = exceptions,
): Exception | undefined =>
  known.find((one) => one.kind === kind && (one.items?.includes(item) ?? true) && one.what.test(what))
