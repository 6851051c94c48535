import type { RobotView } from '@botgarten/lab'

/** Does it show or sound anything? */
export const isTelling = ({ display, frequency, speech }: RobotView): boolean =>
  frequency !== null || speech !== null || display.some(Boolean)
