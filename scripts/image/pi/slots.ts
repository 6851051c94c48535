/** One of the two systems of a card; an update goes to the other one. */
export type Slot = 'a' | 'b'

export const other = (slot: Slot): Slot => (slot === 'a' ? 'b' : 'a')

/** Number of its partition. */
export const partitionOf = { a: '02', b: '03' } as const

/** All of `slot.txt`: what the firmware starts. Of one length, so that writing it is writing one sector. */
export const slotLine = (slot: Slot): string => `os_prefix=${slot}/\n`

/** Fills the template of `cmdline.txt`. @param disk id of the partition table, 8 hex digits */
export const fill = (template: string, disk: string, slot: Slot = 'a'): string =>
  template.replaceAll('@disk@', disk).replaceAll('@part@', partitionOf[slot]).replaceAll('@slot@', slot)

/** From where the running kernel was started, by its command line; null on another machine. */
export function startedFrom(commandLine: string): { readonly disk: string; readonly slot: Slot } | null {
  const disk = /(?:^|\s)root=PARTUUID=([0-9a-f]{8})-0[23](?:\s|$)/.exec(commandLine)?.[1]
  const slot = /(?:^|\s)botgarten\.slot=([ab])(?:\s|$)/.exec(commandLine)?.[1] as Slot | undefined
  return disk === undefined || slot === undefined ? null : { disk, slot }
}

/**
 * How an update is: `wanted` before the restart, `running` once the first root has made the system before the one that
 * starts next (scripts/local-premount), then `kept` or `failed`.
 */
export interface Trial {
  readonly state: 'wanted' | 'running' | 'kept' | 'failed'
  readonly slot: Slot
}

/** All of `trial.txt`; null where there is none, or what stands there is nothing. */
export function readTrial(text: string): Trial | null {
  const [, state, slot] = /^(wanted|running|kept|failed) ([ab])\s*$/.exec(text) ?? []
  return state === undefined ? null : { state: state as Trial['state'], slot: slot as Slot }
}

export const trialLine = ({ state, slot }: Trial): string => `${state} ${slot}\n`

/** What the system that was started does: try itself, note that the other one failed, or nothing. */
export function taskOf(slot: Slot, trial: Trial | null): 'try' | 'failed' | 'nothing' {
  if (trial === null || trial.state === 'kept' || trial.state === 'failed') return 'nothing'
  return trial.slot === slot ? 'try' : 'failed'
}
