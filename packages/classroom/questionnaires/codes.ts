const hours = 3_600_000
const kept = 4 * hours
/** More than are in any class; then a code is only compared with those that were sent. */
const most = 300

/**
 * Codes that children have chosen and not yet sent, so that a second child hears that one is taken. In the memory alone: a
 * database would hold when each was chosen.
 */
export class ChosenCodes {
  private readonly byForm = new Map<string, { since: number; readonly byId: Map<string, string> }>()

  /** A child chooses a code, in place of the one before. @param id of its answer @returns false where it is another's */
  choose(form: string, id: string, code: string, now: number): boolean {
    this.forget(now)
    const { byId } = this.of(form, now)
    for (const [other, chosen] of byId) if (chosen === code && other !== id) return false
    if (byId.size < most || byId.has(id)) byId.set(id, code)
    return true
  }

  private of(form: string, now: number) {
    const found = this.byForm.get(form) ?? { since: now, byId: new Map<string, string>() }
    found.since = now
    this.byForm.set(form, found)
    return found
  }

  private forget(now: number) {
    for (const [form, { since }] of this.byForm) if (now - since > kept) this.byForm.delete(form)
  }
}
