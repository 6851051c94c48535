/**
 * How surely this browser keeps what is here. `lasting`: until the child throws it away · `asking`: it would ask the child
 * first · `passing`: it may clear it when room is needed · `unsaid`: a page over plain http cannot know.
 */
export type Lasting = 'lasting' | 'asking' | 'passing' | 'unsaid'

/** `navigator.storage` is only there on secure pages. */
const manager = (): StorageManager | null => navigator.storage ?? null

async function permission(): Promise<PermissionState | null> {
  try {
    return (await navigator.permissions.query({ name: 'persistent-storage' })).state
  } catch {
    return null
  }
}

/** Asks for lasting storage where that disturbs nobody, and says how it stands. */
export async function quietlyAskLasting(): Promise<Lasting> {
  try {
    const storage = manager()
    if (!storage?.persist) return 'unsaid'
    if (await storage.persisted()) return 'lasting'
    const allowed = await permission()
    if (allowed === 'granted') return (await storage.persist()) ? 'lasting' : 'passing'
    return allowed === 'denied' ? 'passing' : 'asking'
  } catch (cause) {
    console.warn('The browser does not say how long it keeps things.', cause)
    return 'unsaid'
  }
}

/** Asks, from a press of the child's: the browser may show a question of its own. */
export async function askLasting(): Promise<Lasting> {
  try {
    return (await manager()?.persist()) ? 'lasting' : 'passing'
  } catch (cause) {
    console.warn('The browser refuses to be asked for lasting storage.', cause)
    return 'passing'
  }
}
