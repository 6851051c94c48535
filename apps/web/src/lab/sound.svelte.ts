import { readSetting, writeSetting } from '#storage/settings.ts'

/** Loudest output: a tone on headphones must never hurt. */
const LOUDEST = 0.08
const FADE_SECONDS = 0.02

/** What the robot's loudspeaker plays. Silent until a tap has allowed it (running.md 12). */
export class Loudspeaker {
  #on = $state(readSetting<unknown>('sound', true) !== false)
  #audio: { context: AudioContext; tone: OscillatorNode; volume: GainNode } | null = null
  #frequency = 0

  get on() {
    return this.#on
  }

  /** Call from a tap: browsers allow sound only then. */
  wake(): void {
    const tapped = navigator.userActivation?.hasBeenActive ?? true
    if (this.#audio || !tapped || typeof AudioContext === 'undefined') return
    const context = new AudioContext()
    const volume = context.createGain()
    const tone = context.createOscillator()
    tone.type = 'triangle'
    volume.gain.value = 0
    tone.connect(volume).connect(context.destination)
    tone.start()
    this.#audio = { context, tone, volume }
  }

  /** @param frequency in hertz; null or 0 is silence */
  play(frequency: number | null): void {
    const wanted = this.#on ? (frequency ?? 0) : 0
    if (wanted === this.#frequency || !this.#audio) return
    this.#frequency = wanted
    const { context, tone, volume } = this.#audio
    if (wanted > 0) tone.frequency.setTargetAtTime(wanted, context.currentTime, FADE_SECONDS)
    volume.gain.setTargetAtTime(wanted > 0 ? LOUDEST : 0, context.currentTime, FADE_SECONDS)
  }

  switch(on: boolean): void {
    this.#on = on
    writeSetting('sound', on)
    if (!on) this.play(null)
  }

  close(): void {
    void this.#audio?.context.close()
  }
}
