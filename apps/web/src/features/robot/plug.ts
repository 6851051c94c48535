import type { Finding } from '@botgarten/blocks'
import { placeFor, withSensor, type SensorKind, type SensorPort } from '@botgarten/simulation'
import { told } from '#lab/told.ts'
import type { LabSession } from '#lab/session.svelte.ts'

type Fix = NonNullable<Finding['fixes']>[number]

/** What the blocks can be told from here. */
interface Blocks {
  setFields(block: string, fields: { readonly [name: string]: string }): void
}

/** Carries out a way out of a finding: sets the field and plugs the sensor in, as one step. */
export function applyFix(session: LabSession, blocks: Blocks, block: string, fix: Fix): void {
  const { field, value, plug } = fix
  const before = session.undo.count
  blocks.setFields(block, { [field]: value })
  if (plug) void told().then(() => plugIn(session, plug, before))
}

interface Plug {
  readonly port: SensorPort
  readonly kind: SensorKind
}

/** `before`: how many steps could be undone before; one more is what this goes together with. */
function plugIn(session: LabSession, { port, kind }: Plug, before: number): void {
  const { config } = session
  const changed = withSensor(config, port, placeFor(kind, config))
  const part = session.undo.count > before ? 'joined' : 'whole'
  session.apply({ kind: 'config', id: session.robotId, after: changed }, part)
}
