/**
 * A line of a dialog: `line` is text that does not matter here, `button` is pressed, `option` one of several, `switch` is
 * turned on, `entry` leads on, `file` is opened, `device` is one of those that a school manages.
 */
export interface Row {
  readonly kind: 'line' | 'button' | 'option' | 'switch' | 'entry' | 'file' | 'device'
  readonly label?: string
  /** What is pressed here. */
  readonly pressed?: boolean
}

/** What is seen at a step: a window of a desktop, the settings of a tablet or phone, or a page of a browser. */
export interface Picture {
  readonly frame: 'window' | 'settings' | 'browser'
  readonly rows: readonly Row[]
}

export const line: Row = { kind: 'line' }
export const row = (kind: Row['kind'], label: string): Row => ({ kind, label })
export const pressed = (kind: Row['kind'], label: string): Row => ({ kind, label, pressed: true })

/** What is pressed, in words and as a drawing. */
export interface Step {
  readonly text: string
  readonly picture: Picture
}

export const step = (text: string, frame: Picture['frame'], ...rows: readonly Row[]): Step => ({
  text,
  picture: { frame, rows },
})
