import { useId, useState } from 'preact/hooks';

interface Props {
  label: string;
  hint: string;
  busy: string | null;
  take: (file: File) => void;
}

/** A place to drop a file, and a button that picks one. */
export function DropZone({ label, hint, busy, take }: Props) {
  const id = useId();
  const [over, setOver] = useState(false);
  const first = (files: FileList | null | undefined) => {
    const file = files?.[0];
    if (file) take(file);
  };
  return (
    <div
      class={`drop ${over ? 'over' : ''}`}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        event.stopPropagation();
        setOver(false);
        first(event.dataTransfer?.files);
      }}
    >
      <input
        id={id} type="file" class="unseen" disabled={busy !== null}
        onChange={(event) => {
          first(event.currentTarget.files);
          event.currentTarget.value = '';
        }}
      />
      <label for={id} class="button main">{label}</label>
      <p class="hint" role="status">{busy ?? hint}</p>
    </div>
  );
}
