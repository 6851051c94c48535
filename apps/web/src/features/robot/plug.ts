import type { Finding } from '@botgarten/blocks'
import { placeFor, withSensor, type SensorKind, type SensorPort } from '@botgarten/simulation'
import { told } from '#lab/told.ts'
import type { LabSession } from '#lab/session.svelte.ts'

type Fix = NonNullable<Finding['fixes']>[number]

/** What the blocks can be told from here. */
interface Blocks {
  setFields(block: string, fields: { readonly [name: string]: string }): void
  addNeuron(network: string, layer: 'input' | 'output'): string | null
}

/** Carries out a way out of a finding: sets the field and plugs the sensor in, as one step. */
export function applyFix(session: LabSession, blocks: Blocks, block: string, fix: Fix): void {
  const { field, value, plug } = fix
  const before = session.undo.count
  blocks.setFields(block, { [field]: value })
  if (plug) void told().then(() => plugIn(session, plug, before))
}

/** Adds a neuron; where nothing sits at the port it looks to, its sensor is plugged in there in the same step. */
export async function addNeuron(
  session: LabSession,
  blocks: Blocks,
  network: string,
  layer: 'input' | 'output',
) {
  const before = session.undo.count
  const block = blocks.addNeuron(network, layer)
  if (block === null) return
  const plug = await missing(session, block)
  if (plug) plugIn(session, plug, before)
}

/** A page that is busy hears of a new block some frames later, and not always of all of it at once. */
const timeout = 20

/** The sensor that has to be plugged in where a new neuron looks for one; undefined where one is there. */
async function missing(session: LabSession, block: string): Promise<Plug | undefined> {
  for (let tries = 0; tries < timeout; tries++) {
    await told()
    const finding = session.findings.find((found) => found.block === block)
    const plug = finding?.fixes?.find((fix) => fix.plug?.port === finding.facts?.port)?.plug
    if (plug) return plug
  }
  return undefined
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
